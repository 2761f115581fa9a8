// Array<1, float3>, array.glift:24.
// Define POINTS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at POINTS_BINDING + 1 + k.
// Optional: POINTS_SET (the descriptor set, else 0), POINTS_STATE (see below), POINTS_READONLY (nothing is written).
#ifndef GLIFT_POINTS
#define GLIFT_POINTS 696865585
#extension GL_EXT_scalar_block_layout : require

#ifndef POINTS_SET
#define POINTS_SET 0
#endif
#ifndef POINTS_BINDING
#error define POINTS_BINDING before this file is included
#endif
#ifdef POINTS_READONLY
#define POINTS_ACCESS readonly
#else
#define POINTS_ACCESS
#endif

#ifndef POINTS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = POINTS_SET, binding = POINTS_BINDING) readonly buffer Points_state {
    uint Points_extent;
};
#endif

layout(scalar, set = POINTS_SET, binding = POINTS_BINDING + 1) POINTS_ACCESS buffer Points_data_memory { vec3 Points_data[]; };

#ifndef GLIFT_HELPER_722867247
#define GLIFT_HELPER_722867247
// Saturates; not-a-number gives 0.
int to_int(float x) {
    float safe = x >= -2147483648.0 && x < 2147483648.0 ? x : 0.0;
    return x >= 2147483648.0 ? 2147483647 : x < -2147483648.0 ? int(0x80000000u) : int(safe);
}
#endif

#ifndef GLIFT_HELPER_1880299949
#define GLIFT_HELPER_1880299949
vec3 blend(vec3 x, vec3 y, vec3 a) {
    return x * (vec3(1.0) - a) + y * a;
}
#endif

uint Points_translate(uint address) {
    return address;
}

vec3 Points_read(uint address) {
    bool Points_value_inside = address < Points_extent;
    vec3 Points_value = Points_data[Points_value_inside ? address : 0u];
    return Points_value_inside ? Points_value : vec3(0.0);
}

vec3 Points_sample(float point) {
    float Points_lower = point - 0.5;
    float Points_corner = floor(Points_lower);
    float Points_weight = Points_lower - Points_corner;
    uint Points_base = uint(to_int(Points_corner));
    bool Points_corner0_value_inside = Points_base < Points_extent;
    vec3 Points_corner0_value = Points_data[Points_corner0_value_inside ? Points_base : 0u];
    uint Points_corner1_address = Points_base + 1u;
    bool Points_corner1_value_inside = Points_corner1_address < Points_extent;
    vec3 Points_corner1_value = Points_data[Points_corner1_value_inside ? Points_corner1_address : 0u];
    return blend(Points_corner0_value_inside ? Points_corner0_value : vec3(0.0), Points_corner1_value_inside
        ? Points_corner1_value : vec3(0.0), vec3(Points_weight));
}

#ifndef POINTS_READONLY
void Points_write(uint address, vec3 value) {
    if (address < Points_extent) {
        Points_data[address] = value;
    }
}
#endif
#elif GLIFT_POINTS != 696865585
#error the functions of another structure called Points are included already
#endif
