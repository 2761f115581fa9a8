// The octree read by a fragment shader that the program wrote, on a Vulkan device that the program made.
#pragma once

#include <glift/vector.h>

#include <vector>

namespace own_shader {

/// Makes an octree, whose page table and frames octree.frag binds, and draws the elements {x, y, 7} of a square of
/// `side` elements. Throws std::runtime_error where Vulkan refuses, glift::Error where Glift does.
std::vector<glift::float4> draw_octree(std::uint32_t side);

}  // namespace own_shader
