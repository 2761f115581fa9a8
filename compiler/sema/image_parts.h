// Structures over images, and over levels and layers of the images of others: `memory data = of.data.mip(1);`.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// Whether what `memory name = …` says is `….mip(n)` or `….layer(n)` of a memory.
bool is_image_part(Body&, ast::ExprId);

void add_image_part(Body&, std::uint32_t structure, const ast::Item&);

/// Whether the last axis of its addresses counts layers, or faces of a cube.
inline bool has_layers(ir::MemoryShape shape) {
    return shape == ir::MemoryShape::image2darray || shape == ir::MemoryShape::imagecube;
}

/// Whether the structure keeps element a in texel a of an image.
bool keeps_texels(const Context&, const ir::Structure&);

/// Whether these have levels that devices filter.
bool has_filtered_levels(const Context&, const ir::Structure&);

/// Adds the memory to the structure, and its name to what is in scope.
void declare_memory(Body&, std::uint32_t structure, const ir::Memory&);

}  // namespace gliftc::sema
