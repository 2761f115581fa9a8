#version 460
// scale, blocks.glift:21: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_control_flow_attributes : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(scalar, set = 0, binding = 0) uniform Parameters {
    uvec2 size;
    uint f_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint f_table_extent;
    uvec2 f_frames_extent;
    uvec3 f_extent;
    float by;
} parameters;

layout(constant_id = 103) const bool copies_parameters = false;
#define parameter(name) (copies_parameters ? name : parameters.name)
uvec2 size;
uint f_active_extent;
uint div_ceil_x;
uint div_ceil_y;
uint div_ceil_y_2;
uint div_ceil_x_2;
uint f_table_extent;
uvec2 f_frames_extent;
uvec3 f_extent;
float by;

layout(scalar, set = 0, binding = 1) readonly buffer G_active_data { uint g_active_data[]; };
layout(scalar, set = 0, binding = 2) readonly buffer F_table_data { uint f_table_data[]; };
layout(scalar, set = 0, binding = 3) readonly buffer F_frames_data { float f_frames_data[]; };
layout(scalar, set = 0, binding = 4) readonly buffer G_table_data { uint g_table_data[]; };
layout(scalar, set = 0, binding = 5) writeonly buffer G_frames_data { float g_frames_data[]; };

layout(constant_id = 104) const bool skips_branches = true;   // the device skips branches that no lane takes

void main() {
    if (copies_parameters) {
        size = parameters.size;
        f_active_extent = parameters.f_active_extent;
        div_ceil_x = parameters.div_ceil_x;
        div_ceil_y = parameters.div_ceil_y;
        div_ceil_y_2 = parameters.div_ceil_y_2;
        div_ceil_x_2 = parameters.div_ceil_x_2;
        f_table_extent = parameters.f_table_extent;
        f_frames_extent = parameters.f_frames_extent;
        f_extent = parameters.f_extent;
        by = parameters.by;
    }
    // blocks.glift:21
    uvec2 address = uvec2(gl_WorkGroupID.x * 512u + gl_LocalInvocationID.x, gl_WorkGroupID.z
        * gl_NumWorkGroups.y + gl_GlobalInvocationID.y);
    if (any(greaterThanEqual(address, parameter(size)))) return;
    // Each invocation takes several elements of a block, a workgroup's width apart.
    bool g_active_value_inside = address.y < parameter(f_active_extent);
    uint g_active_value = g_active_data[g_active_value_inside ? address.y : 0u];
    uint rest = g_active_value_inside ? g_active_value : 0u;
    uint block_x = rest % parameter(div_ceil_x);
    uint rest_1 = rest / parameter(div_ceil_x);
    uint block_y = rest_1 % parameter(div_ceil_y);
    uint block_z = rest_1 / parameter(div_ceil_y);
    uint f_table_address = (block_z * parameter(div_ceil_y_2) + block_y) * parameter(div_ceil_x_2) + block_x;
    bool f_table_value_inside = f_table_address < parameter(f_table_extent);
    uint value = f_table_value_inside ? f_table_address : 0u;
    uint f_table_value = f_table_data[value];
    uint f_entry = f_table_value_inside ? f_table_value : 0u;
    uint f_frames_index = f_entry - 1u;
    bool f_found = !(f_entry == 0u) && f_frames_index < parameter(f_frames_extent).y;
    uint g_table_value = g_table_data[value];
    uint g_entry = f_table_value_inside ? g_table_value : 0u;
    uint g_frames_index = g_entry - 1u;
    bool g_found = !(g_entry == 0u) && g_frames_index < parameter(f_frames_extent).y;
    bool test = block_x <= 536870911u && block_y <= 536870911u && block_z <= 536870911u;
    uint value_1 = block_x * 8u;
    uint value_2 = block_y * 8u;
    uint value_3 = block_z * 8u;
    if (skips_branches
        && (test && all(lessThan(uvec3(value_1 + 7u, value_2 + 7u, value_3 + 7u), parameter(f_extent)))
        && (f_found && g_found))) {
        uint first = address.x;
        uint f_at = f_frames_index * parameter(f_frames_extent).x + first;
        uint g_at = g_frames_index * parameter(f_frames_extent).x + first;
        float g = parameter(by) * f_frames_data[f_at];
        uint f_at_1 = f_at + 64u;
        uint g_at_1 = g_at + 64u;
        float g_1 = parameter(by) * f_frames_data[f_at_1];
        uint f_at_2 = f_at + 128u;
        uint g_at_2 = g_at + 128u;
        float g_2 = parameter(by) * f_frames_data[f_at_2];
        uint f_at_3 = f_at + 192u;
        uint g_at_3 = g_at + 192u;
        float g_3 = parameter(by) * f_frames_data[f_at_3];
        uint f_at_4 = f_at + 256u;
        uint g_at_4 = g_at + 256u;
        float g_4 = parameter(by) * f_frames_data[f_at_4];
        uint f_at_5 = f_at + 320u;
        uint g_at_5 = g_at + 320u;
        float g_5 = parameter(by) * f_frames_data[f_at_5];
        uint f_at_6 = f_at + 384u;
        uint g_at_6 = g_at + 384u;
        float g_6 = parameter(by) * f_frames_data[f_at_6];
        uint f_at_7 = f_at + 448u;
        uint g_at_7 = g_at + 448u;
        float g_7 = parameter(by) * f_frames_data[f_at_7];
        g_frames_data[g_at] = g;
        g_frames_data[g_at_1] = g_1;
        g_frames_data[g_at_2] = g_2;
        g_frames_data[g_at_3] = g_3;
        g_frames_data[g_at_4] = g_4;
        g_frames_data[g_at_5] = g_5;
        g_frames_data[g_at_6] = g_6;
        g_frames_data[g_at_7] = g_7;
    } else {
        [[unroll]] for (uint turn = 0u; turn < 8u; ++turn) {
            uint in_block = address.x + turn * 64u;
            if (test && all(lessThan(uvec3(value_1 + in_block % 8u, value_2 + in_block / 8u % 8u, value_3
                + in_block / 64u), parameter(f_extent)))) {
                uint f_at = f_frames_index * parameter(f_frames_extent).x + in_block;
                uint g_at = g_frames_index * parameter(f_frames_extent).x + in_block;
                float f_value = f_frames_data[f_found ? f_at : 0u];
                if (g_found) {
                    g_frames_data[g_at] = parameter(by) * (f_found ? f_value : -1.0);
                }
            }
        }
    }
}
