#version 460
// add, shared.glift:38: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint f_extent;
    uint f_table_extent;
    uvec2 f_frames_extent;
    uint g_field_extent;
    uint g_field_table_extent;
    uvec2 g_field_frames_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer F_table_data { uint f_table_data[]; };
layout(scalar, set = 0, binding = 2) readonly buffer F_frames_data { float f_frames_data[]; };
layout(scalar, set = 0, binding = 3) readonly buffer G_field_table_data { uint g_field_table_data[]; };
layout(scalar, set = 0, binding = 4) readonly buffer G_field_frames_data { float g_field_frames_data[]; };
layout(scalar, set = 0, binding = 5) readonly buffer To_table_data { uint to_table_data[]; };
layout(scalar, set = 0, binding = 6) writeonly buffer To_frames_data { float to_frames_data[]; };

void main() {
    // shared.glift:38
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= f_extent) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < f_extent;
    uint next = has_next ? value : address;
    bool test = address >= f_extent;
    bool f_either = test;
    if (!f_either) {
        uint f_table_address = address / 16u;
        bool f_table_value_inside = f_table_address < f_table_extent;
        uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
        f_either = (f_table_value_inside ? f_table_value : 0u) == 0u;
    }
    uvec2 f_result = uvec2(0u);
    bool f_found = false;
    if (f_either) {
        f_result = uvec2(0u);
        f_found = false;
    } else {
        uint f_table_address = address / 16u;
        bool f_table_value_inside = f_table_address < f_table_extent;
        uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
        f_result = uvec2(address % 16u, (f_table_value_inside ? f_table_value : 0u) - 1u);
        f_found = true;
    }
    uvec2 f_place = f_result;
    uint f_at = f_place.y * f_frames_extent.x + f_place.x;
    bool f_found_1 = f_found && f_place.y < f_frames_extent.y;
    bool to_either = test;
    if (!to_either) {
        uint to_table_address = address / 16u;
        bool to_table_value_inside = to_table_address < f_table_extent;
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
        bool to_table_value_inside = to_table_address < f_table_extent;
        uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
        to_result = uvec2(address % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
        to_found = true;
    }
    uvec2 to_place = to_result;
    uint to_at = to_place.y * f_frames_extent.x + to_place.x;
    bool to_found_1 = to_found && to_place.y < f_frames_extent.y;
    // shared.glift:39
    float f_value = f_frames_data[f_found_1 ? f_at : 0u];
    uint value_1 = address + 1u;
    bool g_xp1_field_either = value_1 >= g_field_extent;
    if (!g_xp1_field_either) {
        uint g_field_table_address = value_1 / 16u;
        bool g_field_table_value_inside = g_field_table_address < g_field_table_extent;
        uint g_field_table_value = g_field_table_data[g_field_table_value_inside ? g_field_table_address
            : 0u];
        g_xp1_field_either = (g_field_table_value_inside ? g_field_table_value : 0u) == 0u;
    }
    uvec2 g_xp1_field_result = uvec2(0u);
    bool g_xp1_field_found = false;
    if (g_xp1_field_either) {
        g_xp1_field_result = uvec2(0u);
        g_xp1_field_found = false;
    } else {
        uint g_field_table_address = value_1 / 16u;
        bool g_field_table_value_inside = g_field_table_address < g_field_table_extent;
        uint g_field_table_value = g_field_table_data[g_field_table_value_inside ? g_field_table_address
            : 0u];
        g_xp1_field_result = uvec2(value_1 % 16u, (g_field_table_value_inside ? g_field_table_value : 0u)
            - 1u);
        g_xp1_field_found = true;
    }
    uvec2 g_xp1_field_place = g_xp1_field_result;
    bool g_xp1_inside = g_xp1_field_found && g_xp1_field_place.y < g_field_frames_extent.y;
    uint g_xp1_at = g_xp1_field_place.y * g_field_frames_extent.x + g_xp1_field_place.x;
    float g_xp1 = g_field_frames_data[g_xp1_inside ? g_xp1_at : 0u];
    // shared.glift:38
    bool test_1 = next >= f_extent;
    bool f_either_1 = test_1;
    if (!f_either_1) {
        uint f_table_address = next / 16u;
        bool f_table_value_inside = f_table_address < f_table_extent;
        uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
        f_either_1 = (f_table_value_inside ? f_table_value : 0u) == 0u;
    }
    uvec2 f_result_1 = uvec2(0u);
    bool f_found_2 = false;
    if (f_either_1) {
        f_result_1 = uvec2(0u);
        f_found_2 = false;
    } else {
        uint f_table_address = next / 16u;
        bool f_table_value_inside = f_table_address < f_table_extent;
        uint f_table_value = f_table_data[f_table_value_inside ? f_table_address : 0u];
        f_result_1 = uvec2(next % 16u, (f_table_value_inside ? f_table_value : 0u) - 1u);
        f_found_2 = true;
    }
    uvec2 f_place_1 = f_result_1;
    uint f_at_1 = f_place_1.y * f_frames_extent.x + f_place_1.x;
    bool f_found_3 = f_found_2 && f_place_1.y < f_frames_extent.y;
    bool to_either_1 = test_1;
    if (!to_either_1) {
        uint to_table_address = next / 16u;
        bool to_table_value_inside = to_table_address < f_table_extent;
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
        bool to_table_value_inside = to_table_address < f_table_extent;
        uint to_table_value = to_table_data[to_table_value_inside ? to_table_address : 0u];
        to_result_1 = uvec2(next % 16u, (to_table_value_inside ? to_table_value : 0u) - 1u);
        to_found_2 = true;
    }
    uvec2 to_place_1 = to_result_1;
    uint to_at_1 = to_place_1.y * f_frames_extent.x + to_place_1.x;
    bool to_found_3 = to_found_2 && to_place_1.y < f_frames_extent.y;
    // shared.glift:39
    float f_value_1 = f_frames_data[f_found_3 ? f_at_1 : 0u];
    uint value_2 = next + 1u;
    bool g_xp1_field_either_1 = value_2 >= g_field_extent;
    if (!g_xp1_field_either_1) {
        uint g_field_table_address = value_2 / 16u;
        bool g_field_table_value_inside = g_field_table_address < g_field_table_extent;
        uint g_field_table_value = g_field_table_data[g_field_table_value_inside ? g_field_table_address
            : 0u];
        g_xp1_field_either_1 = (g_field_table_value_inside ? g_field_table_value : 0u) == 0u;
    }
    uvec2 g_xp1_field_result_1 = uvec2(0u);
    bool g_xp1_field_found_1 = false;
    if (g_xp1_field_either_1) {
        g_xp1_field_result_1 = uvec2(0u);
        g_xp1_field_found_1 = false;
    } else {
        uint g_field_table_address = value_2 / 16u;
        bool g_field_table_value_inside = g_field_table_address < g_field_table_extent;
        uint g_field_table_value = g_field_table_data[g_field_table_value_inside ? g_field_table_address
            : 0u];
        g_xp1_field_result_1 = uvec2(value_2 % 16u, (g_field_table_value_inside ? g_field_table_value : 0u)
            - 1u);
        g_xp1_field_found_1 = true;
    }
    uvec2 g_xp1_field_place_1 = g_xp1_field_result_1;
    bool g_xp1_inside_1 = g_xp1_field_found_1 && g_xp1_field_place_1.y < g_field_frames_extent.y;
    uint g_xp1_at_1 = g_xp1_field_place_1.y * g_field_frames_extent.x + g_xp1_field_place_1.x;
    float g_xp1_1 = g_field_frames_data[g_xp1_inside_1 ? g_xp1_at_1 : 0u];
    if (to_found_1) {
        to_frames_data[to_at] = (f_found_1 ? f_value : -1.0) + (g_xp1_inside ? g_xp1 : -1.0);
    }
    if (to_found_3) {
        to_frames_data[to_at_1] = (f_found_3 ? f_value_1 : -1.0) + (g_xp1_inside_1 ? g_xp1_1 : -1.0);
    }
}
