#version 460
// pick, predicates.glift:21: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(push_constant, scalar) uniform Parameters {
    uint x_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer X_data { uint x_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer To_data { uint to_data[]; };

void main() {
    // predicates.glift:21
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 64u) + gl_GlobalInvocationID.x;
    bool in_range = address < x_extent;
    // predicates.glift:22
    bool inside = gl_LocalInvocationIndex < 32u;
    // predicates.glift:23
    uint result = 0u;
    if (inside) {
        uint x_value = 0u;
        if (in_range) {
            x_value = x_data[address];
        }
        result = x_value;
    } else {
        result = 3u;
    }
    uint first = result;
    // predicates.glift:24
    uint result_1 = 0u;
    if (inside) {
        uint x_value = 0u;
        if (in_range) {
            x_value = x_data[address];
        }
        result_1 = x_value;
    } else {
        result_1 = 4u;
    }
    uint second = result_1;
    // predicates.glift:25
    barrier();
    // predicates.glift:26
    if (in_range) {
        to_data[address] = first + second;
    }
}
