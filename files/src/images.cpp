#include "images.h"

#include <algorithm>

namespace glift::files {

Field texel_field(Format format) {
    const auto field = [](Scalar scalar, std::uint32_t channels) {
        Field made{"", scalar, 0, {}, {}};
        if (channels > 1) made.shape = {channels};
        return made;
    };
    switch (format) {
    case Format::none:
    case Format::r8:
    case Format::r8ui: return field(Scalar::uint8, 1);
    case Format::rg8: return field(Scalar::uint8, 2);
    case Format::rgba8:
    case Format::rgba8ui: return field(Scalar::uint8, 4);
    case Format::r16f: return field(Scalar::float16, 1);
    case Format::rg16f: return field(Scalar::float16, 2);
    case Format::rgba16f: return field(Scalar::float16, 4);
    case Format::r32f:
    case Format::d32: return field(Scalar::float32, 1);
    case Format::rg32f: return field(Scalar::float32, 2);
    case Format::rgba32f: return field(Scalar::float32, 4);
    case Format::r16ui: return field(Scalar::uint16, 1);
    case Format::r32ui: return field(Scalar::uint32, 1);
    case Format::rg32ui: return field(Scalar::uint32, 2);
    case Format::rgba32ui: return field(Scalar::uint32, 4);
    case Format::r32i: return field(Scalar::int32, 1);
    case Format::rg32i: return field(Scalar::int32, 2);
    case Format::rgba32i: return field(Scalar::int32, 4);
    }
    return field(Scalar::uint8, 1);
}

std::vector<std::uint64_t> level_shape(const MemoryDescription& image, std::uint32_t mip) {
    const auto along = [&](unsigned axis) { return std::max<std::uint64_t>(image.extent[axis] >> mip, 1); };
    std::uint64_t faces = 1, depth = along(2);
    if (image.kind == MemoryKind::imagecube) faces = 6, depth = 1;
    if (image.kind == MemoryKind::image2darray) faces = image.extent[2], depth = 1;
    return {faces, depth, along(1), along(0)};
}

std::vector<std::uint64_t> shape_in_file(const MemoryDescription& image, const std::vector<std::uint64_t>& shape) {
    switch (image.kind) {
    case MemoryKind::buffer:
    case MemoryKind::image1d: return {shape[3]};
    case MemoryKind::image2d: return {shape[2], shape[3]};
    case MemoryKind::image3d: return {shape[1], shape[2], shape[3]};
    case MemoryKind::imagecube:
    case MemoryKind::image2darray: return {shape[0], shape[2], shape[3]};
    }
    return shape;
}

ImageRegion region_of(const Batch& batch, std::uint32_t mip) {
    const auto narrow = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
    ImageRegion region;
    region.mip = mip;
    region.face = narrow(batch.origin[0]);
    region.origin = {narrow(batch.origin[3]), narrow(batch.origin[2]), narrow(batch.origin[1])};
    region.extent = {narrow(batch.size[3]), narrow(batch.size[2]), narrow(batch.size[1])};
    return region;
}

}  // namespace glift::files
