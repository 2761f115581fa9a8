#version 460
// double_tiles, guards.glift:8: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_control_flow_attributes : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint tile_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer From_data { uint from_data[]; };
layout(scalar, set = 0, binding = 1) readonly buffer From_data_rows { uvec4 from_data_rows[]; };   // the same memory, as vectors of four
layout(scalar, set = 0, binding = 2) writeonly buffer To_data { uint to_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer To_data_rows { uvec4 to_data_rows[]; };   // the same memory, as vectors of four

void main() {
    // guards.glift:8
    uint address = (gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x) * 64u;
    if (address >= tile_extent) return;
    // guards.glift:9
    for (uint row = 0u; row < 4u; ++row) {
        // guards.glift:10
        uint from_first = address + 16u * row;
        uint from_items[16] = uint[16](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
        bool test = from_first < tile_extent && tile_extent - from_first >= 16u;
        if (test) {
            uint from_vector = from_first / 4u;
            [[unroll]] for (uint row_1 = 0u; row_1 < 4u; ++row_1) {
                uvec4 from_four = from_data_rows[from_vector + row_1];
                uint value = row_1 * 4u;
                from_items[value] = from_four.x;
                from_items[value + 1u] = from_four.y;
                from_items[value + 2u] = from_four.z;
                from_items[value + 3u] = from_four.w;
            }
        } else {
            [[unroll]] for (uint row_1 = 0u; row_1 < 4u; ++row_1) {
                uint value = row_1 * 4u;
                uint from0_address = from_first + value;
                bool from0_value_inside = from0_address < tile_extent;
                uint from0_value = from_data[from0_value_inside ? from0_address : 0u];
                from_items[value] = from0_value_inside ? from0_value : 0u;
                uint from1_address = from0_address + 1u;
                bool from1_value_inside = from1_address < tile_extent;
                uint from1_value = from_data[from1_value_inside ? from1_address : 0u];
                from_items[value + 1u] = from1_value_inside ? from1_value : 0u;
                uint from2_address = from0_address + 2u;
                bool from2_value_inside = from2_address < tile_extent;
                uint from2_value = from_data[from2_value_inside ? from2_address : 0u];
                from_items[value + 2u] = from2_value_inside ? from2_value : 0u;
                uint from3_address = from0_address + 3u;
                bool from3_value_inside = from3_address < tile_extent;
                uint from3_value = from_data[from3_value_inside ? from3_address : 0u];
                from_items[value + 3u] = from3_value_inside ? from3_value : 0u;
            }
        }
        uint items[16] = from_items;
        // guards.glift:11
        uint results[16] = uint[16](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
        // guards.glift:12
        [[unroll]] for (uint j = 0u; j < 16u; ++j) {
            // guards.glift:13
            results[j] = 2u * items[j];
        }
        // guards.glift:15
        uint to_items[16] = results;
        if (test) {
            uint to_vector = from_first / 4u;
            [[unroll]] for (uint row_1 = 0u; row_1 < 4u; ++row_1) {
                uint value = row_1 * 4u;
                to_data_rows[to_vector + row_1] = uvec4(to_items[value], to_items[value + 1u],
                    to_items[value + 2u], to_items[value + 3u]);
            }
        } else {
            [[unroll]] for (uint row_1 = 0u; row_1 < 4u; ++row_1) {
                uint value = row_1 * 4u;
                uint to_address = from_first + value;
                if (to_address < tile_extent) {
                    to_data[to_address] = to_items[value];
                }
                uint to_address_1 = to_address + 1u;
                if (to_address_1 < tile_extent) {
                    to_data[to_address_1] = to_items[value + 1u];
                }
                uint to_address_2 = to_address + 2u;
                if (to_address_2 < tile_extent) {
                    to_data[to_address_2] = to_items[value + 2u];
                }
                uint to_address_3 = to_address + 3u;
                if (to_address_3 < tile_extent) {
                    to_data[to_address_3] = to_items[value + 3u];
                }
            }
        }
    }
}
