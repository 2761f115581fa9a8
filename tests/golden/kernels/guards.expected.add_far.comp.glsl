#version 460
// add_far, guards.glift:20: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint tile_extent;
    uint far;
};

layout(scalar, set = 0, binding = 1) readonly buffer From_data { uint from_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer To_data { uint to_data[]; };

void main() {
    // guards.glift:20
    uint address = (gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x) * 8u;
    if (address >= tile_extent) return;
    // guards.glift:21
    for (uint j = 0u; j < 8u; ++j) {
        // guards.glift:22
        uint i = address + j;
        // guards.glift:23
        bool from_value_inside = i < tile_extent;
        uint from_value = from_data[from_value_inside ? i : 0u];
        uint from_value_1 = from_value_inside ? from_value : 0u;
        if (from_value_1 > 3u) {
            // guards.glift:24
            uint from_address = i * far;
            bool from_value_inside_1 = from_address < tile_extent;
            uint from_value_2 = from_data[from_value_inside_1 ? from_address : 0u];
            if (from_value_inside) {
                to_data[i] = from_value_1 + (from_value_inside_1 ? from_value_2 : 0u);
            }
        }
    }
}
