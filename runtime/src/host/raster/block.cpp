#include "host/raster/block.h"

#include <glift/host/parallel.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace glift::host::raster {

namespace {

/// An edge function at a block's first pixel, divided by 256, so that it grows by `a` or `b` with a step of one pixel.
/// The value is clamped to -2^29 and 2^29, so that the values at the block's pixels fit 32 bits; that changes the sign
/// at none of these pixels.
std::int32_t start_of(const Edge& edge, std::int32_t x, std::int32_t y) {
    const std::int64_t value = (edge.c >> subpixel_bits) + std::int64_t{edge.a} * x + std::int64_t{edge.b} * y;
    constexpr std::int64_t limit = 1 << 29;
    return static_cast<std::int32_t>(std::clamp(value, -limit, limit));
}

/// The pixels of a block in columns [left, right) and rows [top, bottom).
std::uint64_t box(std::int32_t left, std::int32_t top, std::int32_t right, std::int32_t bottom) {
    const std::uint64_t row = ((1u << (right - left)) - 1u) << left;
    std::uint64_t all = 0;
    for (std::int32_t y = top; y < bottom; ++y) all |= row << (block_side * y);
    return all;
}

/// A bit for each pixel of a block, set where an edge value is negative: outside of the triangle. Only rows [top,
/// bottom) are computed, which are few for most triangles of large meshes.
GLIFT_HOST_KERNEL std::uint64_t outside(const std::int32_t (&start)[3], const std::int32_t (&a)[3],
                                        const std::int32_t (&b)[3], std::int32_t top, std::int32_t bottom) {
    std::uint64_t result = 0;
    for (std::int32_t y = top; y < bottom; ++y) {
        std::uint8_t signs[block_side];
        const std::int32_t row0 = start[0] + y * b[0], row1 = start[1] + y * b[1], row2 = start[2] + y * b[2];
        for (std::int32_t x = 0; x < block_side; ++x)
            signs[x] = ((row0 + x * a[0]) | (row1 + x * a[1]) | (row2 + x * a[2])) < 0;
        std::uint64_t bytes;
        std::memcpy(&bytes, signs, sizeof bytes);
        // The low bits of eight bytes, as eight bits.
        result |= (bytes * 0x0102040810204080ull >> 56) << (block_side * y);
    }
    return result;
}

/// The pixels in columns [left, right) and rows [top, bottom) at which no edge value is negative. For few pixels.
std::uint64_t few_inside(const std::int32_t (&start)[3], const std::int32_t (&a)[3], const std::int32_t (&b)[3],
                         std::int32_t left, std::int32_t top, std::int32_t right, std::int32_t bottom) {
    std::uint64_t result = 0;
    for (std::int32_t y = top; y < bottom; ++y)
        for (std::int32_t x = left; x < right; ++x) {
            const std::int32_t signs =
                (start[0] + x * a[0] + y * b[0]) | (start[1] + x * a[1] + y * b[1]) | (start[2] + x * a[2] + y * b[2]);
            result |= std::uint64_t{signs >= 0} << (block_side * y + x);
        }
    return result;
}

template <class Compare> std::uint64_t tested(const DepthTarget& target, int2 first, const float* depth,
                                              std::uint64_t pixels_left, Compare passes) {
    std::uint64_t passed = 0;
    for (std::uint64_t left = pixels_left; left != 0; left &= left - 1) {
        const int pixel = std::countr_zero(left);
        const auto x = static_cast<std::size_t>(first.x + pixel % block_side);
        const auto y = static_cast<std::size_t>(first.y + pixel / block_side);
        float& stored = target.texels[y * target.row + x];
        if (!passes(depth[pixel], stored)) continue;
        passed |= std::uint64_t{1} << pixel;
        if (target.is_written) stored = depth[pixel];
    }
    return passed;
}

}  // namespace

std::uint64_t coverage(const Triangle& triangle, std::int32_t x, std::int32_t y) {
    std::int32_t start[3], a[3], b[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const Edge& edge = triangle.edges[i];
        start[i] = start_of(edge, x, y);
        a[i] = edge.a;
        b[i] = edge.b;
    }
    const std::int32_t top = std::max(triangle.top - y, 0), bottom = std::min(triangle.bottom - y, block_side);
    const std::int32_t left = std::max(triangle.left - x, 0), right = std::min(triangle.right - x, block_side);
    constexpr std::int32_t few = 6;  // for so few pixels, few_inside takes no longer than outside
    if ((right - left) * (bottom - top) <= few) return few_inside(start, a, b, left, top, right, bottom);
    const std::uint64_t inside = box(left, top, right, bottom);
    return inside & ~outside(start, a, b, top, bottom);
}

Rows rows_of(std::uint64_t covered) {
    return {std::countr_zero(covered) / block_side & ~1, ((63 - std::countl_zero(covered)) / block_side | 1) + 1};
}

GLIFT_HOST_KERNEL void interpolate_depth(const Triangle& triangle, std::int32_t left, std::int32_t top,
                                         const Rows& rows, Fragments& fragments) {
    // Weights are interpolated from the block's first pixel, where they are computed in double precision, so that their
    // error does not grow with the size of the triangle.
    float start[3], right[3], down[3];
    for (int i = 1; i < 3; ++i) {
        const Edge& edge = triangle.edges[static_cast<std::size_t>(i)];
        const double value =
            static_cast<double>(edge.c + (std::int64_t{edge.a} * left + std::int64_t{edge.b} * top) * 256);
        start[i] = static_cast<float>((value + triangle.offset[i]) * triangle.inverse_area);
        right[i] = static_cast<float>(edge.a) * 256.0f * triangle.inverse_area;
        down[i] = static_cast<float>(edge.b) * 256.0f * triangle.inverse_area;
    }
    const float z0 = triangle.z[0], z1 = triangle.z[1] - z0, z2 = triangle.z[2] - z0;
    for (int y = rows.first; y < rows.end; ++y) {
        const float row = static_cast<float>(y);
        for (int x = 0; x < block_side; ++x) {
            const float column = static_cast<float>(x);
            const float weight1 = start[1] + column * right[1] + row * down[1];
            const float weight2 = start[2] + column * right[2] + row * down[2];
            fragments.linear1[y * block_side + x] = weight1;
            fragments.linear2[y * block_side + x] = weight2;
            fragments.depth[y * block_side + x] = z0 + weight1 * z1 + weight2 * z2;
        }
    }
}

GLIFT_HOST_KERNEL void interpolate_smooth(const Triangle& triangle, const Rows& rows, Fragments& fragments) {
    const float w0 = triangle.inverse_w[0], w1 = triangle.inverse_w[1], w2 = triangle.inverse_w[2];
    for (int y = rows.first; y < rows.end; ++y)
        for (int i = y * block_side; i < (y + 1) * block_side; ++i) {
            const float inverse_w = w0 + fragments.linear1[i] * (w1 - w0) + fragments.linear2[i] * (w2 - w0);
            fragments.w[i] = inverse_w;
            fragments.smooth1[i] = fragments.linear1[i] * w1 / inverse_w;
            fragments.smooth2[i] = fragments.linear2[i] * w2 / inverse_w;
        }
}

std::uint64_t test_depth(const DepthTarget& target, int2 first, const float* depth, std::uint64_t pixels_left) {
    const auto run = [&](auto passes) { return tested(target, first, depth, pixels_left, passes); };
    switch (target.test) {
    case DepthTest::less: return run([](float a, float b) { return a < b; });
    case DepthTest::less_equal: return run([](float a, float b) { return a <= b; });
    case DepthTest::greater: return run([](float a, float b) { return a > b; });
    case DepthTest::equal: return run([](float a, float b) { return a == b; });
    case DepthTest::always: return run([](float, float) { return true; });
    }
    return 0;
}

}  // namespace glift::host::raster

namespace glift::host {

std::uint64_t Fragments::test(std::uint64_t pixels) const {
    if (depth_target->texels == nullptr || depth_target->is_early) return pixels;
    return raster::test_depth(*depth_target, first, depth, pixels);
}

}  // namespace glift::host
