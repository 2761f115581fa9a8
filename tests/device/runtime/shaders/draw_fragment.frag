// Writes the colour and counts fragments in count[0].
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference : require
layout(early_fragment_tests) in;
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Counts { uint count[]; };
layout(set = 0, binding = 0, scalar) readonly buffer Parameters {
    uint corners, instances;
    float shift;
    uint unused[3];
    Counts at;
};
layout(location = 0) smooth in vec4 colour;
layout(location = 0) out vec4 image;
void main() {
    atomicAdd(at.count[0], 1u);
    image = colour;
}
