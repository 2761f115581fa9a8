// Quotients of floats whose exact result takes much code in shaders.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// The code of an exact quotient (emit/glsl/division.cpp), in nodes of other operations.
inline constexpr std::size_t nodes_of_long_quotient = 64;

/// Whether the operation is such a quotient.
inline bool is_long_quotient(const Context& cx, const ir::Expr& node) {
    return node.op == ir::Op::binary && node.binary == ir::BinaryOp::divide && !cx.kernel.fast_math &&
           cx.p.types.is_floating(cx.p.types.scalar_of(node.type));
}

}  // namespace gliftc::lower
