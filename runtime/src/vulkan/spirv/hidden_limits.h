// Hides the limits of loops that end at zero from a driver's optimiser.
//
// NVIDIA's driver (580.159, seen on an H100 and an H200) loses the last round of a loop that counts by one from a
// constant below -1 to 0, if it knows both ends: `for (int i = -2; i < 1; ++i)` is done for -2 and -1. Which of those
// loops it gets wrong depends on what else the shader computes, so all of them are changed: in a module with an int
// constant below -1, comparisons of ints by <, <=, > and >= with 0 or 1 that tell 0 from 1 get a limit that the driver
// does not know. Loops that end elsewhere, and loops that end by !=, were compiled correctly and stay as they are.
// Whether loops over 64-bit integers or vectors are affected is not known; they stay as they are, too.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The module with the limits 0 and 1 of such comparisons hidden. Modules without a constant below -1 stay as they are,
/// and so do modules without the invocation's or the workgroup's number among their inputs (draws).
std::vector<std::uint32_t> with_hidden_limits(std::span<const std::uint32_t> spirv);

}  // namespace glift::detail
