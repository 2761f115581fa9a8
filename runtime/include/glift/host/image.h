// Images of the host device: conversion between stored and computed values, bounds-checked loads and stores, filtered
// reads.
#pragma once

#include <glift/host/math.h>
#include <glift/host/memory.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace glift::host {

namespace detail {

/// A channel stored as an 8-bit fraction of one.
struct Unorm8 {
    std::uint8_t bits;
};

inline float decode(Unorm8 c) { return static_cast<float>(c.bits) / 255.0f; }
inline float decode(half c) { return c; }
inline float decode(float c) { return c; }
inline std::uint32_t decode(std::uint8_t c) { return c; }
inline std::uint32_t decode(std::uint16_t c) { return c; }
inline std::uint32_t decode(std::uint32_t c) { return c; }
inline std::int32_t decode(std::int32_t c) { return c; }

/// Clamped to 0 to 1 and rounded to the nearest fraction, ties to even, as Vulkan may convert to unorm; NaN gives zero.
inline void encode(Unorm8& c, float v) {
    c.bits = static_cast<std::uint8_t>(convert<uint>(round(clamp(v, 0.0f, 1.0f) * 255.0f)));
}
inline void encode(half& c, float v) { c = half(v); }
inline void encode(float& c, float v) { c = v; }
/// Integers are clamped to the format's largest value.
inline void encode(std::uint8_t& c, std::uint32_t v) { c = static_cast<std::uint8_t>(v < 255u ? v : 255u); }
inline void encode(std::uint16_t& c, std::uint32_t v) { c = static_cast<std::uint16_t>(v < 65535u ? v : 65535u); }
inline void encode(std::uint32_t& c, std::uint32_t v) { c = v; }
inline void encode(std::int32_t& c, std::int32_t v) { c = v; }

template <class C, unsigned N> struct TexelOf {
    using Channel = C;
    static constexpr unsigned channels = N;
};

template <Format F> constexpr auto texel_of() {
    if constexpr (F == Format::r8) return TexelOf<Unorm8, 1>();
    else if constexpr (F == Format::rg8) return TexelOf<Unorm8, 2>();
    else if constexpr (F == Format::rgba8) return TexelOf<Unorm8, 4>();
    else if constexpr (F == Format::r16f) return TexelOf<half, 1>();
    else if constexpr (F == Format::rg16f) return TexelOf<half, 2>();
    else if constexpr (F == Format::rgba16f) return TexelOf<half, 4>();
    else if constexpr (F == Format::r32f || F == Format::d32) return TexelOf<float, 1>();
    else if constexpr (F == Format::rg32f) return TexelOf<float, 2>();
    else if constexpr (F == Format::rgba32f) return TexelOf<float, 4>();
    else if constexpr (F == Format::r8ui) return TexelOf<std::uint8_t, 1>();
    else if constexpr (F == Format::rgba8ui) return TexelOf<std::uint8_t, 4>();
    else if constexpr (F == Format::r16ui) return TexelOf<std::uint16_t, 1>();
    else if constexpr (F == Format::r32ui) return TexelOf<std::uint32_t, 1>();
    else if constexpr (F == Format::rg32ui) return TexelOf<std::uint32_t, 2>();
    else if constexpr (F == Format::rgba32ui) return TexelOf<std::uint32_t, 4>();
    else if constexpr (F == Format::r32i) return TexelOf<std::int32_t, 1>();
    else if constexpr (F == Format::rg32i) return TexelOf<std::int32_t, 2>();
    else return TexelOf<std::int32_t, 4>();
}

template <class T> constexpr unsigned components = 1;
template <class T, unsigned N> constexpr unsigned components<vec<T, N>> = N;

inline std::array<std::int64_t, 3> coordinates(std::int32_t at) { return {at, 0, 0}; }
inline std::array<std::int64_t, 3> coordinates(const int2& at) { return {at.x, at.y, 0}; }
inline std::array<std::int64_t, 3> coordinates(const int3& at) { return {at.x, at.y, at.z}; }

/// Where a mip level begins, in texels, and how large it is.
struct Level {
    std::size_t first = 0;
    std::array<std::int64_t, 3> extent;
};

inline Level level_of(const HostMemory& memory, std::uint32_t level) {
    Level result{0, {memory.extent[0], memory.extent[1], memory.extent[2]}};
    for (std::uint32_t i = 0; i < level; ++i) {
        result.first += static_cast<std::size_t>(result.extent[0] * result.extent[1] * result.extent[2]);
        const unsigned halved = memory.has_layers ? 2 : 3;
        for (unsigned axis = 0; axis < halved; ++axis)
            result.extent[axis] = std::max<std::int64_t>(result.extent[axis] / 2, 1);
    }
    return result;
}

/// Where a texel lies in its memory; null outside of the image, and for a level that it does not have.
template <Format F>
std::byte* texel_address(const HostMemory& memory, const std::array<std::int64_t, 3>& at, std::uint32_t level = 0) {
    using Texel = decltype(texel_of<F>());
    if (level >= memory.mips) return nullptr;
    const Level mip = level_of(memory, level);
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (at[axis] < 0 || at[axis] >= mip.extent[axis]) return nullptr;
    }
    const std::size_t index =
        mip.first + static_cast<std::size_t>((at[2] * mip.extent[1] + at[1]) * mip.extent[0] + at[0]);
    return memory.data + index * (sizeof(typename Texel::Channel) * Texel::channels);
}

template <class T> void set_component(T& value, unsigned i, auto channel) {
    if constexpr (components<T> == 1) value = static_cast<T>(channel);
    else value[i] = static_cast<std::remove_cvref_t<decltype(value.x)>>(channel);
}

/// Channels that the format lacks are 0, a missing fourth one is 1.
template <Format F, class T> T decode_texel(const std::byte* address) {
    using Texel = decltype(texel_of<F>());
    T value{};
    if constexpr (components<T> == 4 && Texel::channels < 4) set_component(value, 3, 1);
    for (unsigned i = 0; i < Texel::channels && i < components<T>; ++i) {
        typename Texel::Channel channel;
        std::memcpy(&channel, address + i * sizeof(channel), sizeof(channel));
        set_component(value, i, decode(channel));
    }
    return value;
}

}  // namespace detail

/// The texel's value; zero outside of the image, and in a level that it does not have.
template <Format F, class T, class At> T load_texel(const HostMemory& memory, const At& at, std::int32_t level = 0) {
    const std::byte* address =
        detail::texel_address<F>(memory, detail::coordinates(at), static_cast<std::uint32_t>(level));
    return address ? detail::decode_texel<F, T>(address) : T{};
}

namespace detail {

template <Format F, class T> void encode_texel(std::byte* address, const T& value) {
    using Texel = decltype(texel_of<F>());
    for (unsigned i = 0; i < Texel::channels; ++i) {
        typename Texel::Channel channel{};
        if constexpr (components<T> == 1) {
            if (i == 0) encode(channel, value);
        } else if (i < components<T>) {
            encode(channel, value[i]);
        }
        std::memcpy(address + i * sizeof(channel), &channel, sizeof(channel));
    }
}

}  // namespace detail

/// Stores to level 0; does nothing outside of the image.
template <Format F, class T, class At> void store_texel(const HostMemory& memory, const At& at, const T& value) {
    std::byte* address = detail::texel_address<F>(memory, detail::coordinates(at));
    if (address) detail::encode_texel<F>(address, value);
}

/// A texel of level 0, of one 32-bit channel, for atomics and other accesses through `coherent` parameters. Outside of
/// the image: a dummy variable of the calling thread.
template <Format F, class T, class At> T& texel(const HostMemory& memory, const At& at) {
    static thread_local T nowhere;
    std::byte* address = detail::texel_address<F>(memory, detail::coordinates(at));
    return address ? *reinterpret_cast<T*>(address) : nowhere;
}

namespace detail {

inline std::array<float, 3> as_array(float at) { return {at, 0.5f, 0.5f}; }
inline std::array<float, 3> as_array(const float2& at) { return {at.x, at.y, 0.5f}; }
inline std::array<float, 3> as_array(const float3& at) { return {at.x, at.y, at.z}; }

inline std::uint32_t nearest_level(const HostMemory& memory, float level) {
    const float clamped = clamp(round(level), 0.0f, static_cast<float>(memory.mips - 1));
    return convert<uint>(clamped);
}

/// Interpolates between the two levels around `level`; of_level(i) gives the value in level i.
template <class OfLevel> auto between_levels(const HostMemory& memory, float level, OfLevel&& of_level) {
    const float last = static_cast<float>(memory.mips - 1);
    const float clamped = level >= 0.0f ? (level < last ? level : last) : 0.0f;  // a NaN counts as 0
    const std::uint32_t low = convert<uint>(floor(clamped));
    const auto lower = of_level(low);
    const float weight = clamped - floor(clamped);
    return weight == 0.0f ? lower : mix(lower, of_level(low + 1), weight);
}

/// The weight of the texel after `texel`. At infinity both are the edge's texel, whatever their weights are.
inline float fraction(float texel) {
    const float result = texel - floor(texel);
    return result >= 0.0f ? result : 0.0f;
}

/// The texel at coordinates that are clamped to the edge.
template <Format F, class T>
T clamped_texel(const HostMemory& memory, std::array<std::int64_t, 3> at, std::uint32_t level) {
    const Level mip = level_of(memory, level);
    for (unsigned axis = 0; axis < 3; ++axis)
        at[axis] = at[axis] < 0 ? 0 : at[axis] >= mip.extent[axis] ? mip.extent[axis] - 1 : at[axis];
    return decode_texel<F, T>(texel_address<F>(memory, at, level));
}

}  // namespace detail

/// The texel in which the normalised coordinates lie, in the level nearest to `level`; beyond an edge, the edge's
/// texel. A third coordinate is rounded to the number of a layer if the image has layers.
template <Format F, class T, class At> T sample_nearest(const HostMemory& memory, const At& at, float level = 0.0f) {
    const std::array<float, 3> point = detail::as_array(at);
    const std::uint32_t mip = detail::nearest_level(memory, level);
    const auto extent = detail::level_of(memory, mip).extent;
    std::array<std::int64_t, 3> texel;
    for (unsigned axis = 0; axis < 3; ++axis)
        texel[axis] = convert<std::int32_t>(floor(point[axis] * static_cast<float>(extent[axis])));
    if (detail::components<At> == 3 && memory.has_layers) texel[2] = convert<std::int32_t>(round(point[2]));
    return detail::clamped_texel<F, T>(memory, texel, mip);
}

namespace detail {

/// Linear interpolation between texel centres of one level.
template <Format F, class T, class At> T sample_of_level(const HostMemory& memory, const At& at, std::uint32_t mip) {
    const std::array<float, 3> point = as_array(at);
    const auto extent = level_of(memory, mip).extent;
    const unsigned axes = components<At> == 3 && memory.has_layers ? 2 : components<At>;
    std::array<std::int64_t, 3> low{};
    std::array<float, 3> weight{};
    for (unsigned axis = 0; axis < axes; ++axis) {
        const float texel = point[axis] * static_cast<float>(extent[axis]) - 0.5f;
        low[axis] = convert<std::int32_t>(floor(texel));
        weight[axis] = fraction(texel);
    }
    if (axes < components<At>) low[2] = convert<std::int32_t>(round(point[2]));
    std::array<T, 8> corners;
    for (unsigned i = 0; i < (1u << axes); ++i)
        corners[i] = clamped_texel<F, T>(memory, {low[0] + (i & 1), low[1] + (i >> 1 & 1), low[2] + (i >> 2)}, mip);
    for (unsigned axis = 0; axis < axes; ++axis) {
        for (unsigned i = 0; i < (1u << (axes - 1 - axis)); ++i)
            corners[i] = mix(corners[2 * i], corners[2 * i + 1], weight[axis]);
    }
    return corners[0];
}

}  // namespace detail

/// Linear interpolation between texel centres along each axis, x first, then between the two levels around `level`; in
/// the nearest layer if the image has layers.
template <Format F, class T, class At> T sample_linear(const HostMemory& memory, const At& at, float level = 0.0f) {
    return detail::between_levels(memory, level,
                                  [&](std::uint32_t mip) { return detail::sample_of_level<F, T>(memory, at, mip); });
}

namespace detail {

/// The first of the four texels that a linear filter takes, and along each axis the weight of the texel after it.
struct Corner {
    std::array<std::int64_t, 3> low{};
    std::array<float, 2> weight{};
};

template <class At> Corner corner_of(const HostMemory& memory, const At& at) {
    const std::array<float, 3> point = as_array(at);
    Corner corner;
    for (unsigned axis = 0; axis < 2; ++axis) {
        const float texel = point[axis] * static_cast<float>(memory.extent[axis]) - 0.5f;
        corner.low[axis] = convert<std::int32_t>(floor(texel));
        corner.weight[axis] = fraction(texel);
    }
    if (components<At> == 3) corner.low[2] = convert<std::int32_t>(round(point[2]));
    return corner;
}

template <Format F, class T> T texel_of_corner(const HostMemory& memory, const Corner& corner, unsigned i) {
    return clamped_texel<F, T>(memory, {corner.low[0] + (i & 1), corner.low[1] + (i >> 1), corner.low[2]}, 0);
}

template <Compare C> bool compares(float reference, float texel) {
    if constexpr (C == Compare::less) return reference < texel;
    else if constexpr (C == Compare::less_equal) return reference <= texel;
    else if constexpr (C == Compare::greater) return reference > texel;
    else return reference >= texel;
}

}  // namespace detail

/// The four texels of level 0 of a 2-D image that a linear filter takes, row by row; if the image has layers, those of
/// the nearest layer.
template <Format F, class T, class At> vec<T, 4> gather(const HostMemory& memory, const At& at) {
    const detail::Corner corner = detail::corner_of(memory, at);
    vec<T, 4> texels;
    for (unsigned i = 0; i < 4; ++i) texels[i] = detail::texel_of_corner<F, T>(memory, corner, i);
    return texels;
}

/// Compares `reference` with the four texels of level 0 that a linear filter takes; each comparison gives 1 or 0, and
/// these are interpolated as the filter interpolates texels.
template <Format F, Compare C, class At> float compare_linear(const HostMemory& memory, const At& at, float reference) {
    const detail::Corner corner = detail::corner_of(memory, at);
    float passed[4];
    for (unsigned i = 0; i < 4; ++i)
        passed[i] = detail::compares<C>(reference, detail::texel_of_corner<F, float>(memory, corner, i)) ? 1.0f : 0.0f;
    return mix(mix(passed[0], passed[1], corner.weight[0]), mix(passed[2], passed[3], corner.weight[0]),
               corner.weight[1]);
}

}  // namespace glift::host
