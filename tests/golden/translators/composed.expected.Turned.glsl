// Turned, composed.glift:19.
// Define TURNED_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at TURNED_BINDING + 1 + k.
// Optional: TURNED_SET (the descriptor set, else 0), TURNED_STATE (see below), TURNED_READONLY (nothing is written).
#ifndef GLIFT_TURNED
#define GLIFT_TURNED 1348606716
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

uint Turned_translate(uvec2 address) {
    return address.x * Turned_extent.y + address.y;
}

float Turned_read(uvec2 address) {
    bool Turned_value_inside = all(lessThan(address, Turned_extent));
    uint Turned_value_at = address.x * Turned_extent.y + address.y;
    float Turned_value = Turned_data[Turned_value_inside ? Turned_value_at : 0u];
    return Turned_value_inside ? Turned_value : 0.0;
}

#ifndef TURNED_READONLY
void Turned_write(uvec2 address, float value) {
    if (all(lessThan(address, Turned_extent))) {
        Turned_data[address.x * Turned_extent.y + address.y] = value;
    }
}
#endif
#elif GLIFT_TURNED != 1348606716
#error the functions of another structure called Turned are included already
#endif
