#version 460
// count_digits, large_arrays.glift:9: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint row_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer From_data { uint from_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer Counts_data { uint counts_data[]; };

void main() {
    // large_arrays.glift:9
    uint address = (gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x) * 256u;
    if (address >= row_extent) return;
    // large_arrays.glift:10
    uint found[256];
    for (uint found_at = 0u; found_at < 256u; ++found_at) {
        found[found_at] = 0u;
    }
    // large_arrays.glift:11
    for (uint k = 0u; k < 256u; ++k) {
        // large_arrays.glift:12
        uint from_address = address + k;
        bool from_value_inside = from_address < row_extent;
        uint from_value = from_data[from_value_inside ? from_address : 0u];
        uint value = (from_value_inside ? from_value : 0u) & 0x000000ffu;
        found[value] += 1u;
    }
    // large_arrays.glift:14
    for (uint d = 0u; d < 256u; ++d) {
        // large_arrays.glift:15
        uint counts_address = address + d;
        if (counts_address < row_extent) {
            counts_data[counts_address] = found[d];
        }
    }
}
