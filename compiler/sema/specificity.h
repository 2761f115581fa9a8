// Which of two overloads is written more closely for the types that both take.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// Whether b takes whatever a takes, as both are written, and not the other way round: `vec<N, float>` is more special
/// than `vec<N, T>`, that more than `T`, and `(T, T)` more than `(T, U)`.
bool is_more_special(const Context&, const ast::Decl& a, const ast::Decl& b);

}  // namespace gliftc::sema
