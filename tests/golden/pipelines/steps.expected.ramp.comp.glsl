#version 460
// ramp, steps.glift:8: whole ranges, shared state.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint a_extent;
};

layout(scalar, set = 0, binding = 1) writeonly buffer F_data { float f_data[]; };

void main() {
    // steps.glift:8
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= a_extent) return;
    f_data[address] = float(address);
}
