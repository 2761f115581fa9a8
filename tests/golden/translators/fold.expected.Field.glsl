// Field, fold.glift:26.
// Define FIELD_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at FIELD_BINDING + 1 + k.
// Optional: FIELD_SET (the descriptor set, else 0), FIELD_STATE (see below), FIELD_READONLY (nothing is written).
#ifndef GLIFT_FIELD
#define GLIFT_FIELD 1901467074
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

layout(set = FIELD_SET, binding = FIELD_BINDING + 1, r32f) uniform FIELD_ACCESS image2D Field_data;

uvec2 Field_translate(uvec3 address) {
    uint Field_i = (address.z * Field_extent.y + address.y) * Field_extent.x + address.x;
    return uvec2(Field_i % 64u, Field_i / 64u);
}

float Field_read(uvec3 address) {
    bool Field_value_inside = all(lessThan(address, Field_extent));
    uint Field_i = (address.z * Field_extent.y + address.y) * Field_extent.x + address.x;
    uvec2 Field_value_at = uvec2(Field_i % 64u, Field_i / 64u);
    float Field_value = imageLoad(Field_data, ivec2(Field_value_inside ? Field_value_at : uvec2(0u))).x;
    return Field_value_inside ? Field_value : 0.0;
}

#ifndef FIELD_READONLY
void Field_write(uvec3 address, float value) {
    if (all(lessThan(address, Field_extent))) {
        uint Field_i = (address.z * Field_extent.y + address.y) * Field_extent.x + address.x;
        imageStore(Field_data, ivec2(uvec2(Field_i % 64u, Field_i / 64u)), vec4(value));
    }
}
#endif
#elif GLIFT_FIELD != 1901467074
#error the functions of another structure called Field are included already
#endif
