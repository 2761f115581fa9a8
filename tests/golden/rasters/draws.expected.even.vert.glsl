#version 460
// even, vertex part, draws.glift:67: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(push_constant, scalar) uniform Parameters {
    float factor;
    vec2 factor_2;
};

layout(scalar, set = 0, binding = 1) readonly buffer Corner_data { vec3 corner_data[]; };

void main() {
    uvec2 address = uvec2(uint(gl_VertexIndex), uint(gl_InstanceIndex));
    // draws.glift:68
    gl_Position = vec4(corner_data[address.x], 1.0);
}
