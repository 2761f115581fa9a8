// Staging of loads in workgroup memory. In a loop such as that over all pairs, or over a row of one matrix and a column
// of another, the invocations of a workgroup load the same elements, each for itself. Here they load the elements of
// some rounds together, each element once, wait for one another, and execute these rounds with the loaded values. In
// two and three dimensions an invocation takes four elements along y, if some loads are the same for these.
//
// Needs: the statements of a kernel after "expand". Guarantees: a second body, for shaders, with the same results: each
// element executes the same rounds in the same order.
//
// Source: Volkov and Demmel, Benchmarking GPUs to Tune Dense Linear Algebra, SC 2008.
#pragma once

#include "lower/transform/several_elements.h"

#include <optional>

namespace gliftc::lower {

/// Absent if there is no gain, or for kernels with a group, blocks or coherent parameters, and draws. Sets Pass::staged
/// and adds to Pass::shared.
std::optional<SeveralElements> staged(Context& cx, const std::vector<StmtId>& body);

}  // namespace gliftc::lower
