// Where the texels of an image lie when they are packed: level after level, in each level face after face (layer after
// layer), row-major.
#pragma once

#include <glift/memory.h>

namespace glift::detail {

/// The extent of one face or layer at a mip level.
std::array<std::uint32_t, 3> mip_extent(const MemoryDescription& image, std::uint32_t mip);
/// The number of faces or layers.
std::uint32_t face_count(const MemoryDescription& image);
/// The bytes of one face or layer at a mip level.
std::uint64_t face_bytes(const MemoryDescription& image, std::uint32_t mip);
/// The byte at which a mip level begins.
std::uint64_t mip_offset(const MemoryDescription& image, std::uint32_t mip);
inline std::uint64_t image_bytes(const MemoryDescription& image) { return mip_offset(image, image.mips); }

}  // namespace glift::detail
