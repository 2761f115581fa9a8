// Hides the limits of loops that end at zero from a driver's optimiser.
//
// NVIDIA's driver (580.159, seen on an H100 and an H200) loses the last round of a loop that counts by one from a
// constant below -1 to 0, if it knows both ends: `for (int i = -2; i < 1; ++i)` is done for -2 and -1. Which of those
// loops it gets wrong depends on what else the shader computes, so all of them are changed: where a module has such a
// constant, comparisons of ints by <, <=, > and >= that tell 0 from 1 have a limit that the driver does not know. Loops
// that end elsewhere, and those that end by !=, were right and stay as they are; of 64-bit integers and of vectors
// nothing is known.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The same module, without limits of 0 and 1 that the driver knows. Modules without the invocation's or the
/// workgroup's number among their inputs (draws) stay as they are.
std::vector<std::uint32_t> with_hidden_limits(std::span<const std::uint32_t> spirv);

}  // namespace glift::detail
