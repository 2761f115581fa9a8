// What is well formed, but surely not meant: parameters that nothing uses, results that nothing writes, statements
// after a jump.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Looks at what is written, not at instances, so that generic code is warned about once.
void warn(Context&, const std::vector<ast::DeclId>& declarations);

}  // namespace gliftc::sema
