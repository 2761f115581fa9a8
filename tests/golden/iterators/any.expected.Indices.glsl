// Array<1, uint>, array.glift:24.
// Define INDICES_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at INDICES_BINDING + 1 + k.
// Optional: INDICES_SET (the descriptor set, else 0), INDICES_STATE (see below), INDICES_READONLY (nothing is written).
#ifndef GLIFT_INDICES
#define GLIFT_INDICES 550445139
#extension GL_EXT_scalar_block_layout : require

#ifndef INDICES_SET
#define INDICES_SET 0
#endif
#ifndef INDICES_BINDING
#error define INDICES_BINDING before this file is included
#endif
#ifdef INDICES_READONLY
#define INDICES_ACCESS readonly
#else
#define INDICES_ACCESS
#endif

#ifndef INDICES_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = INDICES_SET, binding = INDICES_BINDING) readonly buffer Indices_state {
    uint Indices_extent;
};
#endif

layout(scalar, set = INDICES_SET, binding = INDICES_BINDING + 1) INDICES_ACCESS buffer Indices_data_memory { uint Indices_data[]; };

uint Indices_translate(uint address) {
    return address;
}

uint Indices_read(uint address) {
    bool Indices_value_inside = address < Indices_extent;
    uint Indices_value = Indices_data[Indices_value_inside ? address : 0u];
    return Indices_value_inside ? Indices_value : 0u;
}

#ifndef INDICES_READONLY
void Indices_write(uint address, uint value) {
    if (address < Indices_extent) {
        Indices_data[address] = value;
    }
}
#endif
#elif GLIFT_INDICES != 550445139
#error the functions of another structure called Indices are included already
#endif
