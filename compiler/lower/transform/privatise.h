// Privatisation of updates: what the elements of a range write by scatter<S, op> to one address is combined before it
// updates memory. An invocation of a shader takes many elements; what it does with an update depends on its address:
//   tree     the same along x: each invocation combines its elements in a local, the workgroup combines the locals in
//            a tree, and updates memory once
//   column   the same along y or z: each invocation combines its elements in a local, and updates memory once
//   copies   not known before run time, in a buffer of integers that is then seen to be small: the workgroup has
//            copies of the buffer in workgroup memory, and updates each element of memory once
// Updates of other kinds stay as they are. Models: Futhark's reduce_by_index (Henriksen et al., Compiling Generalized
// Histograms for GPU, SC 2020), Kokkos' ScatterView.
//
// Needs: the statements of a kernel after "expand". Guarantees: the same updates, up to the order of sums of floats.
#pragma once

#include "lower/context.h"

#include <array>
#include <optional>
#include <vector>

namespace gliftc::lower {

/// A body for many elements an invocation. It tests itself whether an element is in the range, and has barriers: all
/// invocations of a workgroup have to run it.
struct Privatised {
    std::vector<StmtId> body;
    std::array<std::uint32_t, 3> elements = {1, 1, 1};  ///< of an invocation along each axis; those along x are a
                                                        ///< workgroup's width apart
    std::array<std::uint32_t, 3> group = {256, 1, 1};
};

/// None: there is no gain, or the kernel does not allow it (a group or blocks of its own, draws, loops, returns).
std::optional<Privatised> privatised(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
