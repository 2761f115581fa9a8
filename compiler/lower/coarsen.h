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

/// Several elements of a block, a workgroup's width apart, after what the block decides: in a loop; or without one, for
/// blocks all of whose elements are visited. `whole` is the body for these.
Coarsened coarsened_in_block(Context& cx, const std::vector<StmtId>& body, const std::vector<StmtId>& whole);

/// Whether what statements store may wait until other elements have loaded what they need.
struct StoredLast {
    bool holds = false;
    std::size_t loads = 0, nodes = 0;
};
StoredLast stored_last(Context& cx, const std::vector<StmtId>& body);

/// Whether memory is written by the statement or in it.
bool has_store(const ir::Program& program, const ir::Stmt& stmt);

/// A store whose value is named in `before`, so that it may wait. `ends_in_stores`: no other statements follow.
StmtId with_named_value(Context& cx, StmtId id, bool ends_in_stores, std::vector<StmtId>& before);

/// Whether an invocation of a shader takes two elements.
bool is_coarsened(const ir::Pass& pass);

}  // namespace gliftc::lower
