#version 460
// draw_mesh, vertex part, draws.glift:14: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(location = 0) smooth out vec3 world;

layout(push_constant, scalar) uniform Parameters {
    uint points_extent;
    mat4 camera;
};

layout(scalar, set = 0, binding = 1) readonly buffer Corner_data { uint corner_data[]; };
layout(scalar, set = 0, binding = 2) readonly buffer Points_data { vec3 points_data[]; };

vec4 product(mat4 m, vec4 v) {
    return m[0] * v.x + m[1] * v.y + m[2] * v.z + m[3] * v.w;
}

void main() {
    uvec2 address = uvec2(uint(gl_VertexIndex), uint(gl_InstanceIndex));
    // draws.glift:20
    uint points_address = corner_data[address.x];
    bool points_value_inside = points_address < points_extent;
    vec3 points_value = points_data[points_value_inside ? points_address : 0u];
    world = points_value_inside ? points_value : vec3(0.0);
    // draws.glift:21
    gl_Position = product(camera, vec4(world, 1.0));
}
