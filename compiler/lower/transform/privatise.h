// Privatisation of updates. A kernel that updates elements by scatter<S, op> can send many updates to one element, and
// atomic operations on one element run one after the other. This pass makes a second body, for shaders, in which an
// invocation takes many elements and combines their updates in private or workgroup memory first. The address decides
// how (ir::UpdateWay):
//
//     tree      The address is the same along x. An invocation combines its elements in a local, a tree of 256
//               invocations the locals. One of them updates memory.
//     column    The address is the same along y or z. An invocation combines its elements in a local.
//     run       Some consecutive elements along x have one address. An invocation takes consecutive elements, combines
//               them in a local, and updates memory where the address changes.
//     copies    The address is data. If the call shows that few elements can be updated, the workgroup keeps copies of
//               them in workgroup memory, up to 32 of each, and updates memory once for each element.
//     plain     Elements along x have different addresses, or nothing is known: each element updates memory.
//
// Sums of floats by tree and column have one order on every device (ordered_sums.h), if each is the only update of its
// buffer. For the host device the pass makes a third body, for one element, whose updates of these kinds are outside of
// ifs where the element's address alone decides them.
//
// In kernels over blocks an invocation takes the elements at its position in 16 blocks, for copies in 32; elements that
// have one address in all of a block and in all blocks are combined by a tree, those of one position by a column. In
// kernels with loops an invocation takes one element: there are trees only, and sums of floats have no order.
//
// Sources: Henriksen et al., Compiling Generalized Histograms for GPU, SC 2020 (Futhark's reduce_by_index); Kokkos'
// ScatterView.
//
// Needs: the statements of a kernel after "expand". Guarantees: the same updates; sums of floats in another order.
#pragma once

#include "lower/transform/several_elements.h"

#include <optional>

namespace gliftc::lower {

/// Absent if there is no gain, or for kernels with a group, coherent parameters or returns, and draws.
/// Sets Pass::updates and adds to Pass::shared.
std::optional<SeveralElements> privatised(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
