// Keeps the components of integer texels that a shader writes apart, for a driver that mixes them up.
//
// NVIDIA's driver (580.159, seen on an H200) keeps equal components of an integer texel in one register, and loses one
// of them where several writes have that texel: in `for (k = 0; k < 8; ++k) imageStore(image, at[k], ivec4(a, b, d,
// d))` with an `a / 1000003` as d, all but the first write have a coordinate as their last component. Which writes it
// gets wrong depends on what else the shader computes, so all of them are changed: the components get different values
// that the driver does not know to be zero added.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// The module with the components of integer texels that it writes kept apart. Modules without such writes stay as they
/// are, and so do modules without the invocation's or the workgroup's number among their inputs (draws).
std::vector<std::uint32_t> with_separate_texels(std::span<const std::uint32_t> spirv);

}  // namespace glift::detail
