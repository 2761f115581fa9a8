// Structures whose memory is an image, or a mip level or layer of another structure's image: `memory data =
// of.data.mip(1);`.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// Whether the expression in `memory name = …` has the form `a.b.mip(n)` or `a.b.layer(n)`. add_image_part() checks
/// that `a.b` is an image.
bool is_image_part(Body&, ast::ExprId);

void add_image_part(Body&, ir::StructureId structure, const ast::Item&);

/// Whether the last component of a texel's address, in an image of this shape, is its layer or its face of a cube.
inline bool has_layers(ir::MemoryShape shape) {
    return shape == ir::MemoryShape::image2darray || shape == ir::MemoryShape::imagecube;
}

/// Whether the structure's memory is an image, or a level or layer of one, and not a structure, and element a is kept
/// in texel a: each of its translators is known to return the address unchanged, by a single `return`.
bool keeps_texels(const Context&, const ir::Structure&);

/// Whether keeps_texels() holds, and the image is declared with `mips(n)` and has another format than d32.
bool has_filtered_levels(const Context&, const ir::Structure&);

/// Adds the memory to Structure::memories, and brings its name into scope.
void declare_memory(Body&, ir::StructureId structure, const ir::Memory&);

}  // namespace gliftc::sema
