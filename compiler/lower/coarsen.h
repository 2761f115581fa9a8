// Thread coarsening: an invocation of a shader takes two elements, all loads before the first store. GPUs start
// invocations and wait for memory; with one small element each they do little else (docs/performance.md).
//
// Needs: the statements of a kernel as expanded. Guarantees: where there is no second element it is the first once
// more, stored twice or not again.
#pragma once

#include "lower/expand.h"

namespace gliftc::lower {

/// A body for two elements.
struct Coarsened {
    std::vector<StmtId> body;                           ///< empty: there is no gain, or the kernel cannot be run so
    ExprId in_range;                                    ///< holds for the second element's address
    std::array<std::uint32_t, 3> elements = {1, 1, 1};  ///< along each axis
};

/// `made` made the body: what its near accesses gave is partly the second
/// element's, too.
Coarsened coarsened(Context& cx, const std::vector<StmtId>& body, const Expander& made);

/// All of the first element, then all of the second, if there is one: for statements that may run twice, whatever they
/// read and write.
Coarsened coarsened_in_turn(Context& cx, const std::vector<StmtId>& body);

/// Several elements of a block in a loop, a workgroup's width apart, after what the block decides.
Coarsened coarsened_in_block(Context& cx, const std::vector<StmtId>& body);

/// Whether an invocation of a shader takes two elements.
bool is_coarsened(const ir::Pass& pass);

}  // namespace gliftc::lower
