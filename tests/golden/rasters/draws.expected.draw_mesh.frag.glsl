#version 460
// draw_mesh, fragment part, draws.glift:14: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(location = 0) smooth in vec3 world;
layout(location = 0) out vec4 colour;

layout(push_constant, scalar) uniform Parameters {
    uint points_extent;
    mat4 camera;
};

vec3 cross_product(vec3 a, vec3 b) {
    return a.yzx * b.zxy - a.zxy * b.yzx;
}

float ordered_dot(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

void main() {
    // draws.glift:25
    vec3 v = cross_product(dFdxFine(world), dFdyFine(world));
    vec3 normal = v * vec3(1.0 / sqrt(ordered_dot(v, v)));
    // draws.glift:26
    if (normal.z < 0.0) {
        // draws.glift:27
        discard;
    }
    // draws.glift:29
    colour = vec4(vec3(0.2) + 0.8 * normal.z, 1.0);
}
