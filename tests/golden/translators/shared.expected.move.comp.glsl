#version 460
// move, shared.glift:43: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint from_extent;
    uint from_table_extent;
    uvec2 from_frames_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer From_table_data { uint from_table_data[]; };
layout(scalar, set = 0, binding = 2) readonly buffer From_frames_data { float from_frames_data[]; };
layout(scalar, set = 0, binding = 3) readonly buffer To_table_data { uint to_table_data[]; };
layout(scalar, set = 0, binding = 4) writeonly buffer To_frames_data { float to_frames_data[]; };

void main() {
    // shared.glift:43
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= from_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < from_extent;
    uint next = has_next ? value : address;
    bool to_either = address >= from_extent;
    if (!to_either) {
        uint to_table_address = address / 16u;
        bool to_table_value_inside = to_table_address < from_table_extent;
        uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
        to_either = (to_table_value_inside ? to_table_value : 0u) == 0u;
    }
    uvec2 to_result = uvec2(0u);
    bool to_found = false;
    if (to_either) {
        to_result = uvec2(0u);
        to_found = false;
    } else {
        uint to_table_address = address / 16u;
        bool to_table_value_inside = to_table_address < from_table_extent;
        uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
        to_result = uvec2(address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
        to_found = true;
    }
    uvec2 to_place = to_result;
    uint to_at = to_place.y * from_frames_extent.x + to_place.x;
    bool to_found_1 = to_found && to_place.y < from_frames_extent.y;
    // shared.glift:44
    uint from_address = address / 2u;
    bool from_either = from_address >= from_extent;
    if (!from_either) {
        uint from_table_address = from_address / 16u;
        bool from_table_value_inside = from_table_address < from_table_extent;
        uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
        from_either = (from_table_value_inside ? from_table_value : 0u) == 0u;
    }
    uvec2 from_result = uvec2(0u);
    bool from_found = false;
    if (from_either) {
        from_result = uvec2(0u);
        from_found = false;
    } else {
        uint from_table_address = from_address / 16u;
        bool from_table_value_inside = from_table_address < from_table_extent;
        uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
        from_result = uvec2(from_address % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
        from_found = true;
    }
    uvec2 from_place = from_result;
    bool from_value_inside = from_found && from_place.y < from_frames_extent.y;
    uint from_value_at = from_place.y * from_frames_extent.x + from_place.x;
    float from_value = from_frames_data[from_value_inside ? from_value_at : 0u];
    // shared.glift:43
    bool to_either_1 = next >= from_extent;
    if (!to_either_1) {
        uint to_table_address = next / 16u;
        bool to_table_value_inside = to_table_address < from_table_extent;
        uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
        to_either_1 = (to_table_value_inside ? to_table_value : 0u) == 0u;
    }
    uvec2 to_result_1 = uvec2(0u);
    bool to_found_2 = false;
    if (to_either_1) {
        to_result_1 = uvec2(0u);
        to_found_2 = false;
    } else {
        uint to_table_address = next / 16u;
        bool to_table_value_inside = to_table_address < from_table_extent;
        uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
        to_result_1 = uvec2(next % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
        to_found_2 = true;
    }
    uvec2 to_place_1 = to_result_1;
    uint to_at_1 = to_place_1.y * from_frames_extent.x + to_place_1.x;
    bool to_found_3 = to_found_2 && to_place_1.y < from_frames_extent.y;
    // shared.glift:44
    uint from_address_1 = next / 2u;
    bool from_either_1 = from_address_1 >= from_extent;
    if (!from_either_1) {
        uint from_table_address = from_address_1 / 16u;
        bool from_table_value_inside = from_table_address < from_table_extent;
        uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
        from_either_1 = (from_table_value_inside ? from_table_value : 0u) == 0u;
    }
    uvec2 from_result_1 = uvec2(0u);
    bool from_found_1 = false;
    if (from_either_1) {
        from_result_1 = uvec2(0u);
        from_found_1 = false;
    } else {
        uint from_table_address = from_address_1 / 16u;
        bool from_table_value_inside = from_table_address < from_table_extent;
        uint from_table_value = from_table_data[from_table_value_inside ? from_table_address : 0u];
        from_result_1 = uvec2(from_address_1 % 16u, (from_table_value_inside ? from_table_value : 0u) - 1u);
        from_found_1 = true;
    }
    uvec2 from_place_1 = from_result_1;
    bool from_value_inside_1 = from_found_1 && from_place_1.y < from_frames_extent.y;
    uint from_value_at_1 = from_place_1.y * from_frames_extent.x + from_place_1.x;
    float from_value_1 = from_frames_data[from_value_inside_1 ? from_value_at_1 : 0u];
    if (to_found_1) {
        to_frames_data[to_at] = from_value_inside ? from_value : -1.0;
    }
    if (to_found_3) {
        to_frames_data[to_at_1] = from_value_inside_1 ? from_value_1 : -1.0;
    }
}
