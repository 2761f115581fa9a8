#version 460
// steps, vertex part, draws.glift:60: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(scalar, set = 0, binding = 1) readonly buffer Corner_data { vec3 corner_data[]; };

void main() {
    uvec2 address = uvec2(uint(gl_VertexIndex), uint(gl_InstanceIndex));
    // draws.glift:61
    gl_Position = vec4(corner_data[address.x], 1.0);
}
