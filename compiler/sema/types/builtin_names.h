// The names that the language itself has where a type or a constraint may stand.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// A type (`uint`, `float3`, `float4x4`), a texel format, a shape of memory or a built-in constraint; a Meta of kind
/// `none` for any other name.
Meta builtin(Context&, std::string_view name);

}  // namespace gliftc::sema
