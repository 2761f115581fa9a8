#version 460
// overdraw, vertex part, draws.glift:49: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

out float gl_ClipDistance[1];

layout(push_constant, scalar) uniform Parameters {
    uint points_extent;
    uvec2 counts_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer Corner_data { uint corner_data[]; };
layout(scalar, set = 0, binding = 2) readonly buffer Points_data { vec3 points_data[]; };

void main() {
    uvec2 address = uvec2(uint(gl_VertexIndex), uint(gl_InstanceIndex));
    // draws.glift:51
    uint points_address = corner_data[address.x];
    bool points_value_inside = points_address < points_extent;
    vec3 points_value = points_data[points_value_inside ? points_address : 0u];
    vec3 p = points_value_inside ? points_value : vec3(0.0);
    // draws.glift:52
    gl_ClipDistance[0] = 0.5 - p.z;
    // draws.glift:53
    gl_Position = vec4(p, 1.0);
}
