// Writes the colour and counts fragments in count[0].
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(early_fragment_tests) in;
layout(set = 0, binding = 2, scalar) buffer Counts { uint count[]; };
layout(location = 0) smooth in vec4 colour;
layout(location = 0) out vec4 image;
void main() {
    atomicAdd(count[0], 1u);
    image = colour;
}
