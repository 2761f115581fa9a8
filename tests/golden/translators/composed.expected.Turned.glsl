// Turned, composed.glift:19.
// Define TURNED_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at TURNED_BINDING + 1 + k.
// Optional: TURNED_SET (the descriptor set, else 0), TURNED_STATE (see below), TURNED_READONLY (nothing is written).
#ifndef GLIFT_TURNED
#define GLIFT_TURNED 639186949
#extension GL_EXT_scalar_block_layout : require

#ifndef TURNED_SET
#define TURNED_SET 0
#endif
#ifndef TURNED_BINDING
#error define TURNED_BINDING before this file is included
#endif
#ifdef TURNED_READONLY
#define TURNED_ACCESS readonly
#else
#define TURNED_ACCESS
#endif

#ifndef TURNED_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = TURNED_SET, binding = TURNED_BINDING) readonly buffer Turned_state {
    uvec2 Turned_extent;
};
#endif

layout(scalar, set = TURNED_SET, binding = TURNED_BINDING + 1) TURNED_ACCESS buffer Turned_data_memory { float Turned_data[]; };

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

uint Turned_translate(uvec2 address) {
    return address.x * Turned_extent.y + address.y;
}

float Turned_read(uvec2 address) {
    bool Turned_value_inside = all(lessThan(address, Turned_extent));
    uint Turned_value_at = address.x * Turned_extent.y + address.y;
    float Turned_value = Turned_data[Turned_value_inside ? Turned_value_at : 0u];
    return Turned_value_inside ? Turned_value : 0.0;
}

float Turned_sample(vec2 point) {
    vec2 Turned_lower = point - vec2(0.5);
    vec2 Turned_corner = floor(Turned_lower);
    vec2 Turned_weight = Turned_lower - Turned_corner;
    uvec2 Turned_base = uvec2(to_int(Turned_corner));
    bool Turned_corner0_value_inside = all(lessThan(Turned_base, Turned_extent));
    uint Turned_corner0_value_at = Turned_base.x * Turned_extent.y + Turned_base.y;
    float Turned_corner0_value = Turned_data[Turned_corner0_value_inside ? Turned_corner0_value_at : 0u];
    uvec2 Turned_corner1_address = Turned_base + uvec2(1u, 0u);
    bool Turned_corner1_value_inside = all(lessThan(Turned_corner1_address, Turned_extent));
    uint Turned_corner1_value_at = Turned_corner1_address.x * Turned_extent.y + Turned_corner1_address.y;
    float Turned_corner1_value = Turned_data[Turned_corner1_value_inside ? Turned_corner1_value_at : 0u];
    uvec2 Turned_corner2_address = Turned_base + uvec2(0u, 1u);
    bool Turned_corner2_value_inside = all(lessThan(Turned_corner2_address, Turned_extent));
    uint Turned_corner2_value_at = Turned_corner2_address.x * Turned_extent.y + Turned_corner2_address.y;
    float Turned_corner2_value = Turned_data[Turned_corner2_value_inside ? Turned_corner2_value_at : 0u];
    uvec2 Turned_corner3_address = Turned_base + uvec2(1u, 1u);
    bool Turned_corner3_value_inside = all(lessThan(Turned_corner3_address, Turned_extent));
    uint Turned_corner3_value_at = Turned_corner3_address.x * Turned_extent.y + Turned_corner3_address.y;
    float Turned_corner3_value = Turned_data[Turned_corner3_value_inside ? Turned_corner3_value_at : 0u];
    return blend(blend(Turned_corner0_value_inside ? Turned_corner0_value : 0.0, Turned_corner1_value_inside
        ? Turned_corner1_value : 0.0, Turned_weight.x),
        blend(Turned_corner2_value_inside ? Turned_corner2_value : 0.0, Turned_corner3_value_inside
        ? Turned_corner3_value : 0.0, Turned_weight.x), Turned_weight.y);
}

#ifndef TURNED_READONLY
void Turned_write(uvec2 address, float value) {
    if (all(lessThan(address, Turned_extent))) {
        Turned_data[address.x * Turned_extent.y + address.y] = value;
    }
}
#endif
#elif GLIFT_TURNED != 639186949
#error the functions of another structure called Turned are included already
#endif
