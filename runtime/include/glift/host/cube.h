// Cube images on the host device: sampled by direction, with linear filters that go over the seams between faces.
#pragma once

#include <glift/host/image.h>

namespace glift::host {

namespace detail {

/// A point of a face, both axes from -1 to 1.
struct CubePoint {
    unsigned face = 0;
    float u = 0.0f, v = 0.0f;
};

/// Where a direction meets the cube. Faces 0 to 5 are +x, -x, +y, -y, +z, -z; of components of equal magnitude the
/// later one counts.
inline CubePoint cube_point(const float3& d) {
    const float x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
    if (z >= x && z >= y) return d.z < 0.0f ? CubePoint{5, -d.x / z, -d.y / z} : CubePoint{4, d.x / z, -d.y / z};
    if (y >= x) return d.y < 0.0f ? CubePoint{3, d.x / y, -d.z / y} : CubePoint{2, d.x / y, d.z / y};
    return d.x < 0.0f ? CubePoint{1, d.z / x, -d.y / x} : CubePoint{0, -d.z / x, -d.y / x};
}

/// The direction of a point in the plane of a face.
inline float3 cube_direction(const CubePoint& p) {
    switch (p.face) {
    case 0: return {1.0f, -p.v, -p.u};
    case 1: return {-1.0f, -p.v, p.u};
    case 2: return {p.u, 1.0f, p.v};
    case 3: return {p.u, -1.0f, -p.v};
    case 4: return {p.u, -p.v, 1.0f};
    default: return {-p.u, -p.v, -1.0f};
    }
}

/// The index of the texel at coordinate u or v of a CubePoint (-1 to 1) along an axis of `side` texels; at 1 it is
/// `side`.
inline std::int64_t cube_texel(float at, std::int64_t side) {
    return convert<std::int32_t>(floor((at + 1.0f) * 0.5f * static_cast<float>(side)));
}

/// A texel of a face; beyond one of its edges, the texel of the next face that lies there.
template <Format F, class T>
T cube_texel(const HostMemory& memory, std::array<std::int64_t, 3> at, std::uint32_t level) {
    const std::int64_t side = level_of(memory, level).extent[0];
    if (at[0] < 0 || at[0] >= side || at[1] < 0 || at[1] >= side) {
        const auto centre = [&](std::int64_t texel) {
            return static_cast<float>(2 * texel + 1) / static_cast<float>(side) - 1.0f;
        };
        const CubePoint there =
            cube_point(cube_direction({static_cast<unsigned>(at[2]), centre(at[0]), centre(at[1])}));
        at = {cube_texel(there.u, side), cube_texel(there.v, side), there.face};
    }
    return clamped_texel<F, T>(memory, at, level);
}

/// A linear filter at a direction: interpolates `value({x, y, face})` of the four texels around it. Where three faces
/// meet there are three texels, whose mean stands for the fourth.
template <class V, class Value>
V cube_mix(const HostMemory& memory, const float3& direction, std::uint32_t level, const Value& value) {
    const CubePoint point = cube_point(direction);
    const std::int64_t side = level_of(memory, level).extent[0];
    const float x = (point.u + 1.0f) * 0.5f * static_cast<float>(side) - 0.5f;
    const float y = (point.v + 1.0f) * 0.5f * static_cast<float>(side) - 0.5f;
    const std::int64_t low[2] = {convert<std::int32_t>(floor(x)), convert<std::int32_t>(floor(y))};
    V corners[4];
    unsigned missing = 4;
    for (unsigned i = 0; i < 4; ++i) {
        const std::int64_t at[2] = {low[0] + (i & 1), low[1] + (i >> 1)};
        const bool beyond_both = (at[0] < 0 || at[0] >= side) && (at[1] < 0 || at[1] >= side);
        if (beyond_both) missing = i;
        else corners[i] = value({at[0], at[1], point.face});
    }
    if (missing < 4) {
        V sum{};
        for (unsigned i = 0; i < 4; ++i)
            if (i != missing) sum = sum + corners[i];
        corners[missing] = sum * (1.0f / 3.0f);
    }
    return mix(mix(corners[0], corners[1], x - floor(x)), mix(corners[2], corners[3], x - floor(x)), y - floor(y));
}

}  // namespace detail

/// The texel of a cube in a direction, in the level nearest to `level`.
template <Format F, class T>
T sample_cube_nearest(const HostMemory& memory, const float3& direction, float level = 0.0f) {
    const detail::CubePoint point = detail::cube_point(direction);
    const std::uint32_t mip = detail::nearest_level(memory, level);
    const std::int64_t side = detail::level_of(memory, mip).extent[0];
    return detail::clamped_texel<F, T>(
        memory, {detail::cube_texel(point.u, side), detail::cube_texel(point.v, side), point.face}, mip);
}

/// Linear interpolation between texel centres, over the edges of faces, then between the two levels around `level`.
template <Format F, class T>
T sample_cube_linear(const HostMemory& memory, const float3& direction, float level = 0.0f) {
    return detail::between_levels(memory, level, [&](std::uint32_t mip) {
        return detail::cube_mix<T>(memory, direction, mip, [&](const std::array<std::int64_t, 3>& at) {
            return detail::cube_texel<F, T>(memory, at, mip);
        });
    });
}

/// Compares `reference` with the four texels of level 0 that a linear filter takes; each comparison gives 1 or 0, and
/// these are interpolated as the filter interpolates texels.
template <Format F, Compare C> float compare_cube(const HostMemory& memory, const float3& direction, float reference) {
    return detail::cube_mix<float>(memory, direction, 0, [&](const std::array<std::int64_t, 3>& at) {
        return detail::compares<C>(reference, detail::cube_texel<F, float>(memory, at, 0)) ? 1.0f : 0.0f;
    });
}

}  // namespace glift::host
