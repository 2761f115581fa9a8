// The six properties of a translator (thesis section 3.2.3): inferred where possible, else declared and checked.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Fills Translator::properties, reads `@many_to_one`, `@memory(...)`, `@access(...)` and reports contradictions.
void infer_properties(Context&, std::uint32_t translator, const ast::Decl&);

}  // namespace gliftc::sema
