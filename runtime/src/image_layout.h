// Extents of an image's levels, and where its texels lie in the host device's memory: level after level, in each level
// face after face (layer after layer), row-major without gaps.
#pragma once

#include <glift/memory.h>

namespace glift::detail {

/// The extent of one face or layer at a mip level.
std::array<std::uint32_t, 3> mip_extent(const MemoryDescription& image, std::uint32_t mip);
/// The number of faces or layers; 1 of other images, whose levels count as one face.
std::uint32_t face_count(const MemoryDescription& image);
/// The bytes of one face or layer at a mip level.
std::uint64_t face_bytes(const MemoryDescription& image, std::uint32_t mip);
/// The byte at which a mip level begins.
std::uint64_t mip_offset(const MemoryDescription& image, std::uint32_t mip);
inline std::uint64_t image_bytes(const MemoryDescription& image) { return mip_offset(image, image.mips); }

}  // namespace glift::detail
