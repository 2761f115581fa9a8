#version 460
// right, near_blocks.glift:20: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(scalar, set = 0, binding = 0) uniform Parameters {
    uvec2 size;
    uint f_active_extent;
    uint div_ceil_x;
    uint div_ceil_x_2;
    uint f_table_extent;
    uvec2 f_frames_extent;
    uvec2 f_extent;
} parameters;

layout(constant_id = 103) const bool copies_parameters = false;
#define parameter(name) (copies_parameters ? name : parameters.name)
uvec2 size;
uint f_active_extent;
uint div_ceil_x;
uint div_ceil_x_2;
uint f_table_extent;
uvec2 f_frames_extent;
uvec2 f_extent;

layout(scalar, set = 0, binding = 1) readonly buffer G_active_data { uint g_active_data[]; };
layout(scalar, set = 0, binding = 2) readonly buffer F_table_data { uint f_table_data[]; };
layout(scalar, set = 0, binding = 3) readonly buffer F_frames_data { float f_frames_data[]; };
layout(scalar, set = 0, binding = 4) readonly buffer G_table_data { uint g_table_data[]; };
layout(scalar, set = 0, binding = 5) writeonly buffer G_frames_data { float g_frames_data[]; };

void main() {
    if (copies_parameters) {
        size = parameters.size;
        f_active_extent = parameters.f_active_extent;
        div_ceil_x = parameters.div_ceil_x;
        div_ceil_x_2 = parameters.div_ceil_x_2;
        f_table_extent = parameters.f_table_extent;
        f_frames_extent = parameters.f_frames_extent;
        f_extent = parameters.f_extent;
    }
    // near_blocks.glift:20
    uvec2 address = uvec2(gl_GlobalInvocationID.x, gl_WorkGroupID.z * gl_NumWorkGroups.y
        + gl_GlobalInvocationID.y);
    if (any(greaterThanEqual(address, parameter(size)))) return;
    uint in_block = address.x;
    bool g_active_value_inside = address.y < parameter(f_active_extent);
    uint g_active_value = g_active_data[g_active_value_inside ? address.y : 0u];
    uint rest = g_active_value_inside ? g_active_value : 0u;
    uint block_x = rest % parameter(div_ceil_x);
    uint block_y = rest / parameter(div_ceil_x);
    uint f_table_address = block_y * parameter(div_ceil_x_2) + block_x;
    bool f_table_value_inside = f_table_address < parameter(f_table_extent);
    uint value = f_table_value_inside ? f_table_address : 0u;
    uint f_table_value = f_table_data[value];
    uint f_entry = f_table_value_inside ? f_table_value : 0u;
    uint f_frames_index = f_entry - 1u;
    bool f_found = !(f_entry == 0u) && f_frames_index < parameter(f_frames_extent).y;
    // near_blocks.glift:21
    uint value_1 = block_x * 8u;
    uint block_x_after_room = parameter(f_extent).x - (value_1 + 8u);
    bool block_x_after_exists = block_x_after_room > 0u && block_x < 536870911u;
    uint f_table_address_1 = f_table_address + (block_x_after_exists ? 1u : 0u);
    bool f_table_value_inside_1 = f_table_address_1 < parameter(f_table_extent);
    uint f_table_value_1 = f_table_data[f_table_value_inside_1 ? f_table_address_1 : 0u];
    uint f_xp_entry = f_table_value_inside_1 ? f_table_value_1 : 0u;
    // near_blocks.glift:20
    uint g_table_value = g_table_data[value];
    uint g_entry = f_table_value_inside ? g_table_value : 0u;
    uint g_frames_index = g_entry - 1u;
    bool g_found = !(g_entry == 0u) && g_frames_index < parameter(f_frames_extent).y;
    uint value_2 = in_block % 8u;
    uint value_3 = value_1 + value_2;
    uint f_index = in_block / 8u;
    if (block_x <= 536870911u && block_y <= 536870911u
        && all(lessThan(uvec2(value_3, block_y * 8u + f_index), parameter(f_extent)))) {
        uint f_at = f_frames_index * parameter(f_frames_extent).x + in_block;
        // near_blocks.glift:21
        uint in_block_xp2 = (value_2 + 2u) % 8u;
        bool xp2_crosses = value_2 >= 6u;
        // near_blocks.glift:20
        uint g_at = g_frames_index * parameter(f_frames_extent).x + in_block;
        // near_blocks.glift:21
        bool f_xp2_inside = value_3 + 2u < parameter(f_extent).x
            && (xp2_crosses ? !(f_xp_entry == 0u) && f_xp_entry - 1u < parameter(f_frames_extent).y
            : f_found);
        uint f_xp2_at = ((xp2_crosses ? f_xp_entry : f_entry) - 1u) * parameter(f_frames_extent).x
            + (f_index * 8u + in_block_xp2);
        float f_xp2 = f_frames_data[f_xp2_inside ? f_xp2_at : 0u];
        // near_blocks.glift:22
        float f_value = f_frames_data[f_found ? f_at : 0u];
        if (g_found) {
            g_frames_data[g_at] = (f_xp2_inside ? f_xp2 : 0.0) - (f_found ? f_value : 0.0);
        }
    }
}
