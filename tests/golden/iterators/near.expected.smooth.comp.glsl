#version 460
// smooth, near.glift:9: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 32, local_size_y = 4, local_size_z = 2) in;

layout(push_constant, scalar) uniform Parameters {
    uvec3 f_extent;
};

layout(scalar, set = 0, binding = 1) readonly buffer F_data { float f_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer G_data { float g_data[]; };

void main() {
    // near.glift:9
    uvec3 address = gl_GlobalInvocationID * uvec3(1u, 2u, 1u);
    if (any(greaterThanEqual(address, f_extent))) return;
    // Each invocation takes two elements: its own, and the one in the next row if there is one.
    uint f_extent_yx = f_extent.y * f_extent.x;
    bool has_next = address.y + 1u < f_extent.y;
    uint f_at = (address.z * f_extent.y + address.y) * f_extent.x + address.x;
    // near.glift:10
    float f_data_value = f_data[f_at];
    float sum = -6.0 * f_data_value;
    // near.glift:11
    bool f_xp1_inside = address.x + 1u < f_extent.x;
    uint value = f_xp1_inside ? 1u : 0u;
    float f_xp1 = f_data[f_at + value];
    bool f_xm1_inside = address.x >= 1u;
    uint value_1 = f_xm1_inside ? 1u : 0u;
    float f_xm1 = f_data[f_at - value_1];
    sum += (f_xp1_inside ? f_xp1 : 0.0) + (f_xm1_inside ? f_xm1 : 0.0);
    uint f_at_1 = f_at + (has_next ? f_extent.x : 0u);
    float f_yp1 = f_data[f_at_1];
    float f_yp1_1 = has_next ? f_yp1 : 0.0;
    bool f_ym1_inside = address.y >= 1u;
    float f_ym1 = f_data[f_at - (f_ym1_inside ? f_extent.x : 0u)];
    sum += f_yp1_1 + (f_ym1_inside ? f_ym1 : 0.0);
    bool f_zp1_inside = address.z + 1u < f_extent.z;
    uint value_2 = f_zp1_inside ? f_extent_yx : 0u;
    float f_zp1 = f_data[f_at + value_2];
    bool f_zm1_inside = address.z >= 1u;
    uint value_3 = f_zm1_inside ? f_extent_yx : 0u;
    float f_zm1 = f_data[f_at - value_3];
    sum += (f_zp1_inside ? f_zp1 : 0.0) + (f_zm1_inside ? f_zm1 : 0.0);
    // near.glift:10
    float sum_1 = -6.0 * f_yp1_1;
    // near.glift:11
    float f_xp1_1 = f_data[f_at_1 + value];
    float f_xm1_1 = f_data[f_at_1 - value_1];
    sum_1 += (f_xp1_inside ? f_xp1_1 : 0.0) + (f_xm1_inside ? f_xm1_1 : 0.0);
    bool f_yp1_inside = address.y + 2u < f_extent.y;
    float f_yp1_2 = f_data[f_at_1 + (f_yp1_inside ? f_extent.x : 0u)];
    sum_1 += (f_yp1_inside ? f_yp1_2 : 0.0) + f_data_value;
    float f_zp1_1 = f_data[f_at_1 + value_2];
    float f_zm1_1 = f_data[f_at_1 - value_3];
    sum_1 += (f_zp1_inside ? f_zp1_1 : 0.0) + (f_zm1_inside ? f_zm1_1 : 0.0);
    // near.glift:12
    g_data[f_at] = sum;
    if (has_next) {
        g_data[f_at_1] = sum_1;
    }
}
