#version 460
// histogram, scatter.glift:9: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint s_extent;
    uint bins_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer S_data { uint s_data[]; };
layout(scalar, set = 0, binding = 2) buffer Bins_data { uint bins_data[]; };

void main() {
    // scatter.glift:9
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= s_extent) return;
    uint bins_address = s_data[address] % 64u;
    if (bins_address < bins_extent) {
        atomicAdd(bins_data[bins_address], 1u);
    }
}
