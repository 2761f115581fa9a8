// Array<2, uint>, array.glift:24.
// Define COUNTS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at COUNTS_BINDING + 1 + k.
// Optional: COUNTS_SET (the descriptor set, else 0), COUNTS_STATE (see below), COUNTS_READONLY (nothing is written).
#ifndef GLIFT_COUNTS
#define GLIFT_COUNTS 1055829696
#extension GL_EXT_scalar_block_layout : require

#ifndef COUNTS_SET
#define COUNTS_SET 0
#endif
#ifndef COUNTS_BINDING
#error define COUNTS_BINDING before this file is included
#endif
#ifdef COUNTS_READONLY
#define COUNTS_ACCESS readonly
#else
#define COUNTS_ACCESS
#endif

#ifndef COUNTS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = COUNTS_SET, binding = COUNTS_BINDING) readonly buffer Counts_state {
    uvec2 Counts_extent;
};
#endif

layout(scalar, set = COUNTS_SET, binding = COUNTS_BINDING + 1) COUNTS_ACCESS buffer Counts_data_memory { uint Counts_data[]; };

uint Counts_translate(uvec2 address) {
    return address.y * Counts_extent.x + address.x;
}

uint Counts_read(uvec2 address) {
    bool Counts_value_inside = all(lessThan(address, Counts_extent));
    uint Counts_value_at = address.y * Counts_extent.x + address.x;
    uint Counts_value = Counts_data[Counts_value_inside ? Counts_value_at : 0u];
    return Counts_value_inside ? Counts_value : 0u;
}

#ifndef COUNTS_READONLY
void Counts_write(uvec2 address, uint value) {
    if (all(lessThan(address, Counts_extent))) {
        Counts_data[address.y * Counts_extent.x + address.x] = value;
    }
}
#endif
#elif GLIFT_COUNTS != 1055829696
#error the functions of another structure called Counts are included already
#endif
