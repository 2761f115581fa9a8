// One triangle in one block of 8 x 8 pixels: which pixels it covers, their depth and weights, the depth test.
#pragma once

#include "host/raster/triangle.h"

namespace glift::host::raster {

inline constexpr std::int32_t block_side = Fragments::side;

/// The pixels of the block at (x, y) that a triangle covers, within its bounding box.
std::uint64_t coverage(const Triangle& triangle, std::int32_t x, std::int32_t y);

/// Rows [first, end) of a block, which hold whole quads: both numbers are even.
struct Rows {
    int first, end;
};
/// The rows of the quads that contain one of these pixels. `covered` must not be empty.
Rows rows_of(std::uint64_t covered);

/// Computes depths and linear weights in these rows of the block at (x, y).
void interpolate_depth(const Triangle& triangle, std::int32_t x, std::int32_t y, const Rows& rows,
                       Fragments& fragments);
/// Computes the perspective-correct weights, and 1 / w, from the linear weights that interpolate_depth has set.
void interpolate_smooth(const Triangle& triangle, const Rows& rows, Fragments& fragments);

/// Tests the depths of these pixels of a block against the stored ones. Returns the pixels that pass; stores their
/// depths if the target is written.
std::uint64_t test_depth(const DepthTarget& target, int2 first, const float* depth, std::uint64_t pixels);

}  // namespace glift::host::raster
