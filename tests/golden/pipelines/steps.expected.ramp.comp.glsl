#version 460
// ramp, steps.glift:8: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint a_extent;
};

layout(scalar, set = 0, binding = 1) writeonly buffer F_data { float f_data[]; };

void main() {
    // steps.glift:8
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= a_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < a_extent;
    uint next = has_next ? value : address;
    float f = float(address);
    float f_1 = float(next);
    f_data[address] = f;
    f_data[next] = f_1;
}
