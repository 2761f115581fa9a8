// Functions that the generated shaders of draws call on the host device: writing and interpolation of varyings, sets of
// pixels of a block, derivatives, the late depth test, blending.
#pragma once

#include <glift/host/image.h>
#include <glift/host/raster.h>
#include <glift/kernel.h>

#include <bit>
#include <cstdint>
#include <cstring>

namespace glift::host {

inline constexpr std::uint32_t block_pixels = Fragments::side * Fragments::side;

/// The first pixel of a set of pixels: bit i stands for pixel i of a block. The set must not be empty.
inline std::uint32_t first_of(std::uint64_t pixels) { return static_cast<std::uint32_t>(std::countr_zero(pixels)); }

/// All pixels of the quads (2 x 2 pixels) that contain at least one of these pixels.
inline std::uint64_t quads_of(std::uint64_t pixels) {
    constexpr std::uint64_t left = 0x5555555555555555u, top = 0x00ff00ff00ff00ffu;
    pixels |= (pixels >> 1 & left) | (pixels & left) << 1;
    return pixels | (pixels >> 8 & top) | (pixels & top) << 8;
}

/// Writes a varying to a vertex's floats; integers keep their bits. Returns the address after it.
template <class T> float* put(float* to, const T& value) {
    static_assert(sizeof(T) == detail::components<T> * sizeof(float));
    std::memcpy(to, &value, sizeof(T));
    return to + detail::components<T>;
}

namespace detail {

/// Float `at` of a vertex's varyings, interpolated by the weights of vertices 1 and 2.
inline float between(const Fragments& fragments, std::uint32_t at, float weight1, float weight2) {
    const float first = fragments.corner[0][at];
    return first + weight1 * (fragments.corner[1][at] - first) + weight2 * (fragments.corner[2][at] - first);
}

template <class T> T between_all(const Fragments& fragments, std::uint32_t at, float weight1, float weight2) {
    if constexpr (components<T> == 1) {
        return between(fragments, at, weight1, weight2);
    } else {
        T value;
        for (unsigned i = 0; i < components<T>; ++i) value[i] = between(fragments, at + i, weight1, weight2);
        return value;
    }
}

}  // namespace detail

// A varying that begins at float `at` of each vertex's varyings: `smooth` interpolates it perspective-correctly,
// `linear` linearly in the window, `flat` gives that of the first vertex of the draw's triangle, line or point.
template <class T> T smooth(const Fragments& fragments, std::uint32_t pixel, std::uint32_t at) {
    return detail::between_all<T>(fragments, at, fragments.smooth1[pixel], fragments.smooth2[pixel]);
}
template <class T> T linear(const Fragments& fragments, std::uint32_t pixel, std::uint32_t at) {
    return detail::between_all<T>(fragments, at, fragments.linear1[pixel], fragments.linear2[pixel]);
}
template <class T> T flat(const Fragments& fragments, std::uint32_t at) {
    T value;
    std::memcpy(static_cast<void*>(&value), fragments.flat + at, sizeof(T));
    return value;
}

/// The pixel's centre in the framebuffer, its depth and 1 / w.
inline float4 fragment_place(const Fragments& fragments, const HostTargets& targets, std::uint32_t pixel) {
    const auto at = [&](uint origin, int first, std::uint32_t offset) {
        return static_cast<float>(static_cast<int>(origin) + first + static_cast<int>(offset)) + 0.5f;
    };
    return float4(at(targets.origin.x, fragments.first.x, pixel % Fragments::side),
                  at(targets.origin.y, fragments.first.y, pixel / Fragments::side), fragments.depth[pixel],
                  fragments.w[pixel]);
}

// Derivatives: differences between the two pixels of a quad in the pixel's own row (dFdx) or column (dFdy).
template <class T> T dFdx(const T (&values)[block_pixels], std::uint32_t pixel) {
    return values[pixel | 1] - values[pixel & ~1u];
}
template <class T> T dFdy(const T (&values)[block_pixels], std::uint32_t pixel) {
    return values[pixel | Fragments::side] - values[pixel & ~Fragments::side];
}
template <class T> T fwidth(const T (&values)[block_pixels], std::uint32_t pixel) {
    return abs(dFdx(values, pixel)) + abs(dFdy(values, pixel));
}

/// The late depth test, with depths that the fragment shader assigned, clamped to 0 to 1; returns the pixels that pass.
inline std::uint64_t test_depth(const Fragments& fragments, std::uint64_t pixels, const float* depths) {
    Fragments given = fragments;
    for (std::uint32_t pixel = 0; pixel < block_pixels; ++pixel) given.depth[pixel] = clamp(depths[pixel], 0.0f, 1.0f);
    return given.test(pixels);
}

namespace detail {

template <Format F> constexpr bool is_fraction = std::is_same_v<typename decltype(texel_of<F>())::Channel, Unorm8>;

/// One channel, blended as by Vulkan: `alpha` is the source's.
template <Blend B> float blended(float source, float stored, float alpha) {
    if constexpr (B == Blend::over) return source + (1.0f - alpha) * stored;
    else if constexpr (B == Blend::add) return source + stored;
    else if constexpr (B == Blend::min) return min(source, stored);
    else if constexpr (B == Blend::max) return max(source, stored);
    else return source * stored;
}

template <Format F, Blend B, class T> T blended_texel(const std::byte* address, T source) {
    const T stored = decode_texel<F, T>(address);
    if constexpr (is_fraction<F>) source = clamp(source, 0.0f, 1.0f);
    if constexpr (components<T> == 1) {
        return blended<B>(source, stored, 1.0f);
    } else {
        T result;
        float alpha = 1.0f;
        if constexpr (components<T> == 4) alpha = source[3];
        for (unsigned i = 0; i < components<T>; ++i) result[i] = blended<B>(source[i], stored[i], alpha);
        return result;
    }
}

}  // namespace detail

/// Draws the pixels of a block to a colour target.
template <Format F, Blend B, class T> void draw_colour(const HostTargets::Texels& target, const Fragments& fragments,
                                                       std::uint64_t pixels, const T* colours) {
    using Texel = decltype(detail::texel_of<F>());
    constexpr std::size_t bytes = sizeof(typename Texel::Channel) * Texel::channels;
    for (std::uint64_t left = pixels; left != 0; left &= left - 1) {
        const std::uint32_t pixel = first_of(left);
        const auto x = static_cast<std::size_t>(fragments.first.x + static_cast<int>(pixel % Fragments::side));
        const auto y = static_cast<std::size_t>(fragments.first.y + static_cast<int>(pixel / Fragments::side));
        std::byte* address = target.first + y * target.row + x * bytes;
        if constexpr (B == Blend::replace) detail::encode_texel<F>(address, colours[pixel]);
        else detail::encode_texel<F>(address, detail::blended_texel<F, B>(address, colours[pixel]));
    }
}

}  // namespace glift::host
