#version 460
// sum, closures.glift:36: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint x_extent;
    float twice;
};

layout(scalar, set = 0, binding = 1) buffer X_data { float x_data[]; };

void main() {
    // closures.glift:36
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= x_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < x_extent;
    uint next = has_next ? value : address;
    // closures.glift:38
    float x_value = x_data[address];
    float x = x_value + twice;
    float x_value_1 = x_data[next];
    float x_1 = x_value_1 + twice;
    x_data[address] = x;
    x_data[next] = x_1;
}
