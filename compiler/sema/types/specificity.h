// Partial ordering of overloads by how specialised their parameter types are.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// For two overloads that both take the arguments of a call: whether b accepts everything that a accepts, by the
/// declared types, and not vice versa. `vec<N, float>` is more specialised than `vec<N, T>`, `vec<N, T>` than `T`, and
/// `(T, T)` than `(T, U)`.
bool is_more_special(const Context&, const ast::Decl& a, const ast::Decl& b);

}  // namespace gliftc::sema
