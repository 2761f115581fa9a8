// Array<2, uint, none, image2d>, array.glift:24.
// Define MARKS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at MARKS_BINDING + 1 + k.
// Optional: MARKS_SET (the descriptor set, else 0), MARKS_STATE (see below), MARKS_READONLY (nothing is written).
#ifndef GLIFT_MARKS
#define GLIFT_MARKS 928160100
#extension GL_EXT_scalar_block_layout : require

#ifndef MARKS_SET
#define MARKS_SET 0
#endif
#ifndef MARKS_BINDING
#error define MARKS_BINDING before this file is included
#endif
#ifdef MARKS_READONLY
#define MARKS_ACCESS readonly
#else
#define MARKS_ACCESS
#endif

#ifndef MARKS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = MARKS_SET, binding = MARKS_BINDING) readonly buffer Marks_state {
    uvec2 Marks_extent;
    uvec2 Marks_data_extent;
};
#endif

layout(set = MARKS_SET, binding = MARKS_BINDING + 1, r32ui) uniform MARKS_ACCESS uimage2D Marks_data;

uvec2 Marks_translate(uvec2 address) {
    uint Marks_data_extent_x = max(Marks_data_extent.x, 1u);
    uint Marks_index = address.y * Marks_extent.x + address.x;
    return uvec2(Marks_index % Marks_data_extent_x, Marks_index / Marks_data_extent_x);
}

uint Marks_read(uvec2 address) {
    uint Marks_data_extent_x = max(Marks_data_extent.x, 1u);
    bool Marks_value_inside = all(lessThan(address, Marks_extent));
    uint Marks_index = address.y * Marks_extent.x + address.x;
    uvec2 Marks_value_at = uvec2(Marks_index % Marks_data_extent_x, Marks_index / Marks_data_extent_x);
    uint Marks_value = imageLoad(Marks_data, ivec2(Marks_value_inside ? Marks_value_at : uvec2(0u))).x;
    return Marks_value_inside ? Marks_value : 0u;
}

#ifndef MARKS_READONLY
void Marks_write(uvec2 address, uint value) {
    uint Marks_data_extent_x = max(Marks_data_extent.x, 1u);
    if (all(lessThan(address, Marks_extent))) {
        uint Marks_index = address.y * Marks_extent.x + address.x;
        imageStore(Marks_data,
            ivec2(uvec2(Marks_index % Marks_data_extent_x, Marks_index / Marks_data_extent_x)), uvec4(value));
    }
}
#endif
#elif GLIFT_MARKS != 928160100
#error the functions of another structure called Marks are included already
#endif
