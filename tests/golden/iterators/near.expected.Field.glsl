// Array<3, float>, array.glift:24.
// Define FIELD_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at FIELD_BINDING + 1 + k.
// Optional: FIELD_SET (the descriptor set, else 0), FIELD_STATE (see below), FIELD_READONLY (nothing is written).
#ifndef GLIFT_FIELD
#define GLIFT_FIELD 1786227904
#extension GL_EXT_scalar_block_layout : require

#ifndef FIELD_SET
#define FIELD_SET 0
#endif
#ifndef FIELD_BINDING
#error define FIELD_BINDING before this file is included
#endif
#ifdef FIELD_READONLY
#define FIELD_ACCESS readonly
#else
#define FIELD_ACCESS
#endif

#ifndef FIELD_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = FIELD_SET, binding = FIELD_BINDING) readonly buffer Field_state {
    uvec3 Field_extent;
};
#endif

layout(scalar, set = FIELD_SET, binding = FIELD_BINDING + 1) FIELD_ACCESS buffer Field_data_memory { float Field_data[]; };

#ifndef GLIFT_HELPER_722867247
#define GLIFT_HELPER_722867247
// Saturates; not-a-number gives 0.
int to_int(float x) {
    float safe = x >= -2147483648.0 && x < 2147483648.0 ? x : 0.0;
    return x >= 2147483648.0 ? 2147483647 : x < -2147483648.0 ? int(0x80000000u) : int(safe);
}
#endif

#ifndef GLIFT_HELPER_32019691
#define GLIFT_HELPER_32019691
ivec3 to_int(vec3 a) {
    return ivec3(to_int(a.x), to_int(a.y), to_int(a.z));
}
#endif

#ifndef GLIFT_HELPER_204653774
#define GLIFT_HELPER_204653774
float blend(float x, float y, float a) {
    return x * (float(1.0) - a) + y * a;
}
#endif

uint Field_translate(uvec3 address) {
    return (address.z * Field_extent.y + address.y) * Field_extent.x + address.x;
}

float Field_read(uvec3 address) {
    bool Field_value_inside = all(lessThan(address, Field_extent));
    uint Field_value_at = (address.z * Field_extent.y + address.y) * Field_extent.x + address.x;
    float Field_value = Field_data[Field_value_inside ? Field_value_at : 0u];
    return Field_value_inside ? Field_value : 0.0;
}

float Field_sample(vec3 point) {
    vec3 Field_lower = point - vec3(0.5);
    vec3 Field_corner = floor(Field_lower);
    vec3 Field_weight = Field_lower - Field_corner;
    uvec3 Field_base = uvec3(to_int(Field_corner));
    bool Field_corner0_value_inside = all(lessThan(Field_base, Field_extent));
    uint Field_corner0_value_at = (Field_base.z * Field_extent.y + Field_base.y) * Field_extent.x
        + Field_base.x;
    float Field_corner0_value = Field_data[Field_corner0_value_inside ? Field_corner0_value_at : 0u];
    uvec3 Field_corner1_address = Field_base + uvec3(1u, 0u, 0u);
    bool Field_corner1_value_inside = all(lessThan(Field_corner1_address, Field_extent));
    uint Field_corner1_value_at = (Field_corner1_address.z * Field_extent.y + Field_corner1_address.y)
        * Field_extent.x + Field_corner1_address.x;
    float Field_corner1_value = Field_data[Field_corner1_value_inside ? Field_corner1_value_at : 0u];
    uvec3 Field_corner2_address = Field_base + uvec3(0u, 1u, 0u);
    bool Field_corner2_value_inside = all(lessThan(Field_corner2_address, Field_extent));
    uint Field_corner2_value_at = (Field_corner2_address.z * Field_extent.y + Field_corner2_address.y)
        * Field_extent.x + Field_corner2_address.x;
    float Field_corner2_value = Field_data[Field_corner2_value_inside ? Field_corner2_value_at : 0u];
    uvec3 Field_corner3_address = Field_base + uvec3(1u, 1u, 0u);
    bool Field_corner3_value_inside = all(lessThan(Field_corner3_address, Field_extent));
    uint Field_corner3_value_at = (Field_corner3_address.z * Field_extent.y + Field_corner3_address.y)
        * Field_extent.x + Field_corner3_address.x;
    float Field_corner3_value = Field_data[Field_corner3_value_inside ? Field_corner3_value_at : 0u];
    uvec3 Field_corner4_address = Field_base + uvec3(0u, 0u, 1u);
    bool Field_corner4_value_inside = all(lessThan(Field_corner4_address, Field_extent));
    uint Field_corner4_value_at = (Field_corner4_address.z * Field_extent.y + Field_corner4_address.y)
        * Field_extent.x + Field_corner4_address.x;
    float Field_corner4_value = Field_data[Field_corner4_value_inside ? Field_corner4_value_at : 0u];
    uvec3 Field_corner5_address = Field_base + uvec3(1u, 0u, 1u);
    bool Field_corner5_value_inside = all(lessThan(Field_corner5_address, Field_extent));
    uint Field_corner5_value_at = (Field_corner5_address.z * Field_extent.y + Field_corner5_address.y)
        * Field_extent.x + Field_corner5_address.x;
    float Field_corner5_value = Field_data[Field_corner5_value_inside ? Field_corner5_value_at : 0u];
    uvec3 Field_corner6_address = Field_base + uvec3(0u, 1u, 1u);
    bool Field_corner6_value_inside = all(lessThan(Field_corner6_address, Field_extent));
    uint Field_corner6_value_at = (Field_corner6_address.z * Field_extent.y + Field_corner6_address.y)
        * Field_extent.x + Field_corner6_address.x;
    float Field_corner6_value = Field_data[Field_corner6_value_inside ? Field_corner6_value_at : 0u];
    uvec3 Field_corner7_address = Field_base + uvec3(1u, 1u, 1u);
    bool Field_corner7_value_inside = all(lessThan(Field_corner7_address, Field_extent));
    uint Field_corner7_value_at = (Field_corner7_address.z * Field_extent.y + Field_corner7_address.y)
        * Field_extent.x + Field_corner7_address.x;
    float Field_corner7_value = Field_data[Field_corner7_value_inside ? Field_corner7_value_at : 0u];
    return blend(blend(blend(Field_corner0_value_inside ? Field_corner0_value : 0.0,
        Field_corner1_value_inside ? Field_corner1_value : 0.0, Field_weight.x),
        blend(Field_corner2_value_inside ? Field_corner2_value : 0.0, Field_corner3_value_inside
        ? Field_corner3_value : 0.0, Field_weight.x), Field_weight.y),
        blend(blend(Field_corner4_value_inside ? Field_corner4_value : 0.0, Field_corner5_value_inside
        ? Field_corner5_value : 0.0, Field_weight.x),
        blend(Field_corner6_value_inside ? Field_corner6_value : 0.0, Field_corner7_value_inside
        ? Field_corner7_value : 0.0, Field_weight.x), Field_weight.y), Field_weight.z);
}

#ifndef FIELD_READONLY
void Field_write(uvec3 address, float value) {
    if (all(lessThan(address, Field_extent))) {
        Field_data[(address.z * Field_extent.y + address.y) * Field_extent.x + address.x] = value;
    }
}
#endif
#elif GLIFT_FIELD != 1786227904
#error the functions of another structure called Field are included already
#endif
