// Heights, own_functions.glift:7.
// Define HEIGHTS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at HEIGHTS_BINDING + 1 + k.
// Optional: HEIGHTS_SET (the descriptor set, else 0), HEIGHTS_STATE (see below), HEIGHTS_READONLY (nothing is written).
#ifndef GLIFT_HEIGHTS
#define GLIFT_HEIGHTS 240353074
#extension GL_EXT_scalar_block_layout : require

#ifndef HEIGHTS_SET
#define HEIGHTS_SET 0
#endif
#ifndef HEIGHTS_BINDING
#error define HEIGHTS_BINDING before this file is included
#endif
#ifdef HEIGHTS_READONLY
#define HEIGHTS_ACCESS readonly
#else
#define HEIGHTS_ACCESS
#endif

#ifndef HEIGHTS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = HEIGHTS_SET, binding = HEIGHTS_BINDING) readonly buffer Heights_state {
    uvec2 Heights_heights_extent;
    uint Heights_side;
};
#endif

layout(scalar, set = HEIGHTS_SET, binding = HEIGHTS_BINDING + 1) HEIGHTS_ACCESS buffer Heights_heights_data_memory { float Heights_heights_data[]; };

#ifndef GLIFT_HELPER_722867247
#define GLIFT_HELPER_722867247
// Saturates; not-a-number gives 0.
int to_int(float x) {
    float safe = x >= -2147483648.0 && x < 2147483648.0 ? x : 0.0;
    return x >= 2147483648.0 ? 2147483647 : x < -2147483648.0 ? int(0x80000000u) : int(safe);
}
#endif

#ifndef GLIFT_HELPER_2079582615
#define GLIFT_HELPER_2079582615
ivec2 to_int(vec2 a) {
    return ivec2(to_int(a.x), to_int(a.y));
}
#endif

#ifndef GLIFT_HELPER_204653774
#define GLIFT_HELPER_204653774
float blend(float x, float y, float a) {
    return x * (float(1.0) - a) + y * a;
}
#endif

#ifndef GLIFT_HELPER_55897840
#define GLIFT_HELPER_55897840
// Saturates; not-a-number gives 0.
uint to_uint(float x) {
    float safe = x >= 0.0 && x < 4294967296.0 ? x : 0.0;
    return x >= 4294967296.0 ? 4294967295u : uint(safe);
}
#endif

bool Heights_is_mapped(uvec2 address) {
    return all(lessThan(address, Heights_heights_extent));
}

uvec2 Heights_translate(uvec2 address) {
    return address;
}

float Heights_read(uvec2 address) {
    bool Heights_value_inside = all(lessThan(address, Heights_heights_extent));
    uint Heights_value_at = address.y * Heights_heights_extent.x + address.x;
    float Heights_value = Heights_heights_data[Heights_value_inside ? Heights_value_at : 0u];
    return Heights_value_inside ? Heights_value : 0.0;
}

float Heights_sample(vec2 x) {
    vec2 Heights_heights_lower = x - vec2(0.5);
    vec2 Heights_heights_corner = floor(Heights_heights_lower);
    vec2 Heights_heights_weight = Heights_heights_lower - Heights_heights_corner;
    uvec2 Heights_heights_base = uvec2(to_int(Heights_heights_corner));
    bool Heights_heights_corner0_value_inside = all(lessThan(Heights_heights_base, Heights_heights_extent));
    uint Heights_heights_corner0_value_at = Heights_heights_base.y * Heights_heights_extent.x
        + Heights_heights_base.x;
    float Heights_heights_corner0_value = Heights_heights_data[Heights_heights_corner0_value_inside
        ? Heights_heights_corner0_value_at : 0u];
    uvec2 Heights_heights_corner1_address = Heights_heights_base + uvec2(1u, 0u);
    bool Heights_heights_corner1_value_inside = all(lessThan(Heights_heights_corner1_address,
        Heights_heights_extent));
    uint Heights_heights_corner1_value_at = Heights_heights_corner1_address.y * Heights_heights_extent.x
        + Heights_heights_corner1_address.x;
    float Heights_heights_corner1_value = Heights_heights_data[Heights_heights_corner1_value_inside
        ? Heights_heights_corner1_value_at : 0u];
    uvec2 Heights_heights_corner2_address = Heights_heights_base + uvec2(0u, 1u);
    bool Heights_heights_corner2_value_inside = all(lessThan(Heights_heights_corner2_address,
        Heights_heights_extent));
    uint Heights_heights_corner2_value_at = Heights_heights_corner2_address.y * Heights_heights_extent.x
        + Heights_heights_corner2_address.x;
    float Heights_heights_corner2_value = Heights_heights_data[Heights_heights_corner2_value_inside
        ? Heights_heights_corner2_value_at : 0u];
    uvec2 Heights_heights_corner3_address = Heights_heights_base + uvec2(1u, 1u);
    bool Heights_heights_corner3_value_inside = all(lessThan(Heights_heights_corner3_address,
        Heights_heights_extent));
    uint Heights_heights_corner3_value_at = Heights_heights_corner3_address.y * Heights_heights_extent.x
        + Heights_heights_corner3_address.x;
    float Heights_heights_corner3_value = Heights_heights_data[Heights_heights_corner3_value_inside
        ? Heights_heights_corner3_value_at : 0u];
    float result = blend(blend(Heights_heights_corner0_value_inside ? Heights_heights_corner0_value : 0.0,
        Heights_heights_corner1_value_inside ? Heights_heights_corner1_value : 0.0,
        Heights_heights_weight.x),
        blend(Heights_heights_corner2_value_inside ? Heights_heights_corner2_value : 0.0,
        Heights_heights_corner3_value_inside ? Heights_heights_corner3_value : 0.0,
        Heights_heights_weight.x), Heights_heights_weight.y) + 1.0;
    return result;
}

uint Heights_row_of(vec2 x) {
    uint result = min(to_uint(x.y), Heights_side - 1u);
    return result;
}

// highest_in
// own_functions.glift:15
float Heights_Heights_highest_in(uint row) {
    // own_functions.glift:16
    float highest = 0.0;
    // own_functions.glift:17
    for (uint x = 0u; x < Heights_side; ++x) {
        // own_functions.glift:18
        uvec2 Heights_heights_address = uvec2(x, row);
        bool Heights_heights_value_inside = all(lessThan(Heights_heights_address, Heights_heights_extent));
        uint Heights_heights_value_at = Heights_heights_address.y * Heights_heights_extent.x
            + Heights_heights_address.x;
        float Heights_heights_value = Heights_heights_data[Heights_heights_value_inside
            ? Heights_heights_value_at : 0u];
        highest = max(highest, Heights_heights_value_inside ? Heights_heights_value : 0.0);
    }
    // own_functions.glift:20
    return highest;
}

float Heights_highest_in(uint row) {
    float result = Heights_Heights_highest_in(row);
    return result;
}

#ifndef HEIGHTS_READONLY
void Heights_write(uvec2 address, float value) {
    if (all(lessThan(address, Heights_heights_extent))) {
        Heights_heights_data[address.y * Heights_heights_extent.x + address.x] = value;
    }
}
#endif
#elif GLIFT_HEIGHTS != 240353074
#error the functions of another structure called Heights are included already
#endif
