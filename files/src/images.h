// How texels lie in files: numbers for each channel, as they are stored.
#pragma once

#include "tiling.h"

#include <glift/commands.h>
#include <glift/files/element_type.h>

#include <vector>

namespace glift::files {

/// A texel as a field: `uint8[4]` for rgba8.
Field texel_field(Format format);
/// Faces or layers, then z, y and x of a level.
std::vector<std::uint64_t> level_shape(const MemoryDescription& image, std::uint32_t mip);
/// The same without the axes that this kind of image does not have.
std::vector<std::uint64_t> shape_in_file(const MemoryDescription& image, const std::vector<std::uint64_t>& shape);
/// The region of a batch, which lies in one face.
ImageRegion region_of(const Batch& batch, std::uint32_t mip);

}  // namespace glift::files
