// Tiling of transposed accesses. In `to[a.yx] = x` and `to = x[a.yx]` the invocations of a subgroup, which are
// consecutive along x, access memory with a stride of a row. This pass makes a second body, for shaders, in which a
// workgroup takes a tile of 32 x 32 elements along x and the axis along which the memory is consecutive (y or z), with
// four elements an invocation:
//   loads    With x and that axis exchanged, the workgroup loads the values of its elements into workgroup memory.
//            After a barrier each element takes its own.
//   stores   Each element writes its value to workgroup memory. After a barrier, with x and that axis exchanged, the
//            workgroup stores them.
// In three dimensions a.yxz and a.yzx are tiles of x and y, a.zyx and a.zxy tiles of x and z, stored or loaded; the
// rest of the permutation does not matter.
//
// Sources: Ruetsch and Micikevicius, Optimizing Matrix Transpose in CUDA, 2009.
//
// Needs: the statements of a kernel after "expand". Guarantees: the same loads and stores, of the same elements; loads
// and stores of a workgroup in another order.
#pragma once

#include "lower/transform/several_elements.h"

#include <optional>

namespace gliftc::lower {

/// Absent if there is no transposed access, or for kernels with a group, blocks, reads of neighbours, coherent
/// parameters, loops or returns, and draws. Sets Pass::tiles and adds to Pass::shared.
std::optional<SeveralElements> tiled(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
