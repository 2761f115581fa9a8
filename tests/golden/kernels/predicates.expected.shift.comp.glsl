#version 460
// shift, predicates.glift:10: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(push_constant, scalar) uniform Parameters {
    uint x_extent;
    uint by;
};

layout(scalar, set = 0, binding = 1) readonly buffer From_data { uint from_data[]; };
layout(scalar, set = 0, binding = 2) readonly buffer X_data { uint x_data[]; };
layout(scalar, set = 0, binding = 3) writeonly buffer To_data { uint to_data[]; };

shared uint part[64];

void main() {
    // predicates.glift:10
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 64u) + gl_GlobalInvocationID.x;
    bool in_range = address < x_extent;
    // predicates.glift:12
    uint i = address + by;
    // predicates.glift:13
    bool from_value_inside = i < x_extent;
    uint next = 0u;
    if (from_value_inside) {
        next = from_data[i];
    }
    // predicates.glift:14
    bool test = i % 2u == 0u;
    uint from_address = test ? i : by;
    bool from_value_inside_1 = from_address < x_extent;
    uint chosen = 0u;
    if (from_value_inside_1) {
        chosen = from_data[from_address];
    }
    // predicates.glift:15
    uint x_value = 0u;
    if (in_range) {
        x_value = x_data[address];
    }
    part[gl_LocalInvocationIndex] = x_value + next;
    // predicates.glift:16
    barrier();
    // predicates.glift:17
    uint x_value_1 = 0u;
    if (in_range) {
        x_value_1 = x_data[address];
    }
    if (in_range) {
        to_data[address] = part[min(63u - gl_LocalInvocationIndex, 63u)] + chosen + (test ? chosen : 7u)
            + next + x_value_1;
    }
}
