// Memory as host kernels see it. Kept small: every kernel source includes it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace glift {

/// How `s.compare(x, reference)` compares: `less` is reference < texel, and so on. Texels of level 0 are compared, then
/// the results are filtered. `none`: the sampler does not compare; it filters the texels themselves.
enum class Compare : std::uint8_t { none, less, less_equal, greater, greater_equal };

enum class MemoryKind : std::uint8_t { buffer, image1d, image2d, image3d, imagecube, image2darray };

/// How a texel is stored. Names are those of the language.
enum class Format : std::uint8_t {
    none,  // buffers
    r8,
    rg8,
    rgba8,
    r16f,
    rg16f,
    rgba16f,
    r32f,
    rg32f,
    rgba32f,
    r8ui,
    r16ui,
    r32ui,
    rg32ui,
    rgba32ui,
    r32i,
    rg32i,
    rgba32i,
    rgba8ui,
    d32,
};

/// A memory as it is passed to host kernels.
struct HostMemory {
    std::byte* data;  ///< buffers: elements in scalar layout; images: texels, row-major, no padding
    std::uint64_t bytes;
    std::array<std::uint32_t, 3> extent;  ///< images: texels; of arrays and cubes the third is layers or faces
    Format format;
    std::uint32_t mips;       ///< number of levels, which lie one after the other; cubes: six faces in each
    bool has_layers = false;  ///< the third axis counts layers or faces, which are as many in each level
};

}  // namespace glift
