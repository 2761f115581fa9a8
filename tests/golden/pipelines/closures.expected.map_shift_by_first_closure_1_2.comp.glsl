#version 460
// map<shift_by_first_closure_1>, closures.glift:12: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

struct shift_by_first_closure_1 {
    float first;
};

layout(push_constant, scalar) uniform Parameters {
    uint f_index;
    uint x_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer F_data { shift_by_first_closure_1 f_data[]; };
layout(scalar, set = 0, binding = 2) buffer X_data { float x_data[]; };

void main() {
    // closures.glift:12
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= x_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < x_extent;
    uint next = has_next ? value : address;
    shift_by_first_closure_1 f = f_data[f_index];
    // closures.glift:13
    float x_value = x_data[address];
    float x = x_value - f.first;
    float x_value_1 = x_data[next];
    float x_1 = x_value_1 - f.first;
    x_data[address] = x;
    x_data[next] = x_1;
}
