#version 460
// double_there, frames.glift:34: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint s_frames_n;
    uint s_data_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer G_frames_data { uint g_frames_data[]; };
layout(scalar, set = 0, binding = 2) buffer G_data { float g_data[]; };
layout(scalar, set = 0, binding = 3) readonly buffer S_frames_data { uint s_frames_data[]; };
layout(scalar, set = 0, binding = 4) readonly buffer S_data { float s_data[]; };

void main() {
    // frames.glift:34
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 512u + gl_LocalInvocationID.x;
    if (address >= s_frames_n * 4u) return;
    // Each invocation takes two elements: its own, and the one a workgroup's width further on if there is one.
    uint value = address + 256u;
    bool has_next = value < s_frames_n * 4u;
    uint next = has_next ? value : address;
    uint g_frames_address = address / 4u;
    bool g_frames_value_inside = g_frames_address < s_frames_n;
    uint g_frames_value = g_frames_data[g_frames_value_inside ? g_frames_address : 0u];
    uint g_frame = g_frames_value_inside ? g_frames_value : 0u;
    uint g_place = (g_frame - 1u) * 4u + address % 4u;
    bool g_found = !(g_frame == 0u) && g_place < s_data_extent;
    float g_value = g_data[g_found ? g_place : 0u];
    uint s_address = address + 1u;
    uint s_frames_address = s_address / 4u;
    bool s_frames_value_inside = s_frames_address < s_frames_n;
    uint s_frames_value = s_frames_data[s_frames_value_inside ? s_frames_address : 0u];
    uint s_frame = s_frames_value_inside ? s_frames_value : 0u;
    uint s_place = (s_frame - 1u) * 4u + s_address % 4u;
    bool s_value_inside = !(s_frame == 0u) && s_place < s_data_extent;
    float s_value = s_data[s_value_inside ? s_place : 0u];
    uint g_frames_address_1 = next / 4u;
    bool g_frames_value_inside_1 = g_frames_address_1 < s_frames_n;
    uint g_frames_value_1 = g_frames_data[g_frames_value_inside_1 ? g_frames_address_1 : 0u];
    uint g_frame_1 = g_frames_value_inside_1 ? g_frames_value_1 : 0u;
    uint g_place_1 = (g_frame_1 - 1u) * 4u + next % 4u;
    bool g_found_1 = !(g_frame_1 == 0u) && g_place_1 < s_data_extent;
    float g_value_1 = g_data[g_found_1 ? g_place_1 : 0u];
    uint s_address_1 = next + 1u;
    uint s_frames_address_1 = s_address_1 / 4u;
    bool s_frames_value_inside_1 = s_frames_address_1 < s_frames_n;
    uint s_frames_value_1 = s_frames_data[s_frames_value_inside_1 ? s_frames_address_1 : 0u];
    uint s_frame_1 = s_frames_value_inside_1 ? s_frames_value_1 : 0u;
    uint s_place_1 = (s_frame_1 - 1u) * 4u + s_address_1 % 4u;
    bool s_value_inside_1 = !(s_frame_1 == 0u) && s_place_1 < s_data_extent;
    float s_value_1 = s_data[s_value_inside_1 ? s_place_1 : 0u];
    if (g_found) {
        g_data[g_place] = g_value + (s_value_inside ? s_value : -1.0);
    }
    if (g_found_1) {
        g_data[g_place_1] = g_value_1 + (s_value_inside_1 ? s_value_1 : -1.0);
    }
}
