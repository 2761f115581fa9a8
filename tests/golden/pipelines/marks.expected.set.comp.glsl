#version 460
// set, marks.glift:4: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint f_extent;
    float value;
};

layout(scalar, set = 0, binding = 1) writeonly buffer F_data { float f_data[]; };

void main() {
    // marks.glift:4
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= f_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value_1 = address + 256u;
    bool has_next = value_1 < f_extent;
    uint next = has_next ? value_1 : address;
    // marks.glift:5
    f_data[address] = value;
    f_data[next] = value;
}
