#include "image_layout.h"

#include <algorithm>

namespace glift {

std::uint32_t texel_bytes(Format format) {
    switch (format) {
    case Format::none: return 0;
    case Format::r8:
    case Format::r8ui: return 1;
    case Format::rg8:
    case Format::r16f:
    case Format::r16ui: return 2;
    case Format::rgba8:
    case Format::rgba8ui:
    case Format::rg16f:
    case Format::r32f:
    case Format::r32ui:
    case Format::r32i:
    case Format::d32: return 4;
    case Format::rgba16f:
    case Format::rg32f:
    case Format::rg32ui:
    case Format::rg32i: return 8;
    case Format::rgba32f:
    case Format::rgba32ui:
    case Format::rgba32i: return 16;
    }
    return 0;
}

}  // namespace glift

namespace glift::detail {

std::array<std::uint32_t, 3> mip_extent(const MemoryDescription& image, std::uint32_t mip) {
    const std::uint32_t depth = image.kind == MemoryKind::image2darray ? 1 : image.extent[2];
    return {std::max(image.extent[0] >> mip, 1u), std::max(image.extent[1] >> mip, 1u), std::max(depth >> mip, 1u)};
}

std::uint32_t face_count(const MemoryDescription& image) {
    if (image.kind == MemoryKind::image2darray) return image.extent[2];
    return image.kind == MemoryKind::imagecube ? 6 : 1;
}

std::uint64_t face_bytes(const MemoryDescription& image, std::uint32_t mip) {
    const auto extent = mip_extent(image, mip);
    return std::uint64_t(extent[0]) * extent[1] * extent[2] * texel_bytes(image.format);
}

std::uint64_t mip_offset(const MemoryDescription& image, std::uint32_t mip) {
    std::uint64_t offset = 0;
    for (std::uint32_t level = 0; level < mip; ++level) offset += face_bytes(image, level) * face_count(image);
    return offset;
}

}  // namespace glift::detail
