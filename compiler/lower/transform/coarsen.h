// Thread coarsening: an invocation of a shader takes several elements: two, with large neighbourhoods four, in kernels
// over blocks up to eight. If each invocation takes one element that needs little work, GPUs spend most of the time on
// starting invocations and on waiting for memory (docs/internals/measurements.md).
//
// Needs: the statements of a kernel after "expand". Guarantees: at the end of the range, where an invocation has no
// second element, the code for the second one stores nothing, or the same again as that for the first one. In kernels
// over blocks each element is tested, unless all elements of the block are known to be visited.
#pragma once

#include "lower/expand/expand.h"

namespace gliftc::lower {

/// A body for several elements per invocation.
struct Coarsened {
    std::vector<StmtId> body;  ///< empty: there is no gain, or the kernel does not allow it
    ExprId in_range;  ///< a condition that holds throughout `body`: the second element's address is in the range (in
                      ///< kernels over blocks: the first one's)
    std::array<std::uint32_t, 3> elements = {1, 1, 1};  ///< how many elements along each axis
};

/// Two elements, or four, if `most` allows them, that share most loads of neighbours, all computed before the first
/// store; loads after a store are of memory that the pass does not write. `made` is the expander that made the body: it
/// knows which values neighbour reads gave, some of which the next element uses again.
Coarsened coarsened(Context& cx, const std::vector<StmtId>& body, const Expander& made, std::uint32_t most);

/// Two elements, one after the other: the statements of the first, then, if there is a second one, those of the second.
/// Valid for any loads and stores.
Coarsened coarsened_in_turn(Context& cx, const std::vector<StmtId>& body);

/// In kernels over blocks, several elements of a block, a workgroup's width apart. Values that depend on the block
/// alone come first, then the elements in a loop. `whole` is the body for blocks all of whose elements are visited: for
/// these, devices that skip branches (Builtin::skips_branches) run the elements without a loop, if several elements of
/// `whole` may load before any of them is stored.
Coarsened coarsened_in_block(Context& cx, const std::vector<StmtId>& body, const std::vector<StmtId>& whole);

/// Whether a body has stores, all of which may be delayed until other elements have made their loads; and how many
/// loads, nodes and long quotients it has.
struct StoredLast {
    bool holds = false;
    std::size_t loads = 0, nodes = 0, quotients = 0;
};
StoredLast stored_last(Context& cx, const std::vector<StmtId>& body);

/// Whether the statement is or contains a store to a buffer or image (atomic updates do not count).
bool has_store(const ir::Program& program, const ir::Stmt& stmt);

/// Makes a store that may be delayed: a `let` of its value is added to `before`, if needed. `ends_in_stores`: only
/// stores, and ifs that contain stores, follow in the body, so that no variable changes any more. A statement that is
/// not itself a store is returned as it is.
StmtId with_named_value(Context& cx, StmtId id, bool ends_in_stores, std::vector<StmtId>& before);

/// Whether an invocation of a shader takes more elements than the kernel declares (at<S, n>; else one).
bool is_coarsened(const ir::Pass& pass);

}  // namespace gliftc::lower
