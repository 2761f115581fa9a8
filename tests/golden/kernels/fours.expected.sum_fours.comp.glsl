#version 460
// sum_fours, fours.glift:8: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_control_flow_attributes : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint a_extent;
    uint shift;
};

layout(scalar, set = 0, binding = 1) readonly buffer From_data { uint from_data[]; };
layout(scalar, set = 0, binding = 1) readonly buffer From_data_rows { uvec4 from_data_rows[]; };   // the same memory, as vectors of four
layout(scalar, set = 0, binding = 2) writeonly buffer To_data { uint to_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer To_data_rows { uvec4 to_data_rows[]; };   // the same memory, as vectors of four

void main() {
    // fours.glift:8
    uint address = (gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x) * 4u;
    if (address >= a_extent) return;
    // fours.glift:9
    uint from_items[4] = uint[4](0u, 0u, 0u, 0u);
    uint from_vector = address / 4u;
    uvec4 from_four = from_data_rows[from_vector];
    from_items[0u] = from_four.x;
    uint to_address = address + 1u;
    bool test = to_address < a_extent;
    from_items[1u] = test ? from_four.y : 0u;
    uint to_address_1 = address + 2u;
    bool test_1 = to_address_1 < a_extent;
    from_items[2u] = test_1 ? from_four.z : 0u;
    uint to_address_2 = address + 3u;
    bool test_2 = to_address_2 < a_extent;
    from_items[3u] = test_2 ? from_four.w : 0u;
    uint whole[4] = from_items;
    // fours.glift:10
    uint from_first = address + shift;
    uint from_items_1[4] = uint[4](0u, 0u, 0u, 0u);
    bool from0_value_inside = from_first < a_extent;
    if (from0_value_inside && a_extent - from_first >= 4u && from_first % 4u == 0u) {
        uint from_vector_1 = from_first / 4u;
        uvec4 from_four_1 = from_data_rows[from_vector_1];
        from_items_1[0u] = from_four_1.x;
        from_items_1[1u] = from_four_1.y;
        from_items_1[2u] = from_four_1.z;
        from_items_1[3u] = from_four_1.w;
    } else {
        uint from0_value = from_data[from0_value_inside ? from_first : 0u];
        from_items_1[0u] = from0_value_inside ? from0_value : 0u;
        uint from1_address = from_first + 1u;
        bool from1_value_inside = from1_address < a_extent;
        uint from1_value = from_data[from1_value_inside ? from1_address : 0u];
        from_items_1[1u] = from1_value_inside ? from1_value : 0u;
        uint from2_address = from_first + 2u;
        bool from2_value_inside = from2_address < a_extent;
        uint from2_value = from_data[from2_value_inside ? from2_address : 0u];
        from_items_1[2u] = from2_value_inside ? from2_value : 0u;
        uint from3_address = from_first + 3u;
        bool from3_value_inside = from3_address < a_extent;
        uint from3_value = from_data[from3_value_inside ? from3_address : 0u];
        from_items_1[3u] = from3_value_inside ? from3_value : 0u;
    }
    uint other[4] = from_items_1;
    // fours.glift:11
    uint sums[4] = uint[4](0u, 0u, 0u, 0u);
    // fours.glift:12
    [[unroll]] for (uint k = 0u; k < 4u; ++k) {
        // fours.glift:13
        sums[k] = whole[k] + other[k];
    }
    // fours.glift:15
    uint to_items[4] = sums;
    if (a_extent - address >= 4u && address % 4u == 0u) {
        to_data_rows[from_vector] = uvec4(to_items[0u], to_items[1u], to_items[2u], to_items[3u]);
    } else {
        to_data[address] = to_items[0u];
        if (test) {
            to_data[to_address] = to_items[1u];
        }
        if (test_1) {
            to_data[to_address_1] = to_items[2u];
        }
        if (test_2) {
            to_data[to_address_2] = to_items[3u];
        }
    }
}
