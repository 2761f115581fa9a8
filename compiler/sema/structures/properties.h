// Properties of a translator (ir::Properties): inferred from the code, or declared by attributes.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Fills Translator::properties, of which `partial` and `invertible` are set already, and `affine` is set by lower/.
/// Reads `@many_to_one`, `@one_to_one`, `@memory(...)`, `@access(...)`; reports those that contradict each other or
/// what was inferred, and any other attribute.
void infer_properties(Context&, ir::TranslatorId translator, const ast::Decl&);

}  // namespace gliftc::sema
