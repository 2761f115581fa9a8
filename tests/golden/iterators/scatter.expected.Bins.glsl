// Array<1, uint>, array.glift:24.
// Define BINS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at BINS_BINDING + 1 + k.
// Optional: BINS_SET (the descriptor set, else 0), BINS_STATE (see below), BINS_READONLY (nothing is written).
#ifndef GLIFT_BINS
#define GLIFT_BINS 204953009
#extension GL_EXT_scalar_block_layout : require

#ifndef BINS_SET
#define BINS_SET 0
#endif
#ifndef BINS_BINDING
#error define BINS_BINDING before this file is included
#endif
#ifdef BINS_READONLY
#define BINS_ACCESS readonly
#else
#define BINS_ACCESS
#endif

#ifndef BINS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = BINS_SET, binding = BINS_BINDING) readonly buffer Bins_state {
    uint Bins_extent;
};
#endif

layout(scalar, set = BINS_SET, binding = BINS_BINDING + 1) BINS_ACCESS buffer Bins_data_memory { uint Bins_data[]; };

uint Bins_translate(uint address) {
    return address;
}

uint Bins_read(uint address) {
    bool Bins_value_inside = address < Bins_extent;
    uint Bins_value = Bins_data[Bins_value_inside ? address : 0u];
    return Bins_value_inside ? Bins_value : 0u;
}

#ifndef BINS_READONLY
void Bins_write(uint address, uint value) {
    if (address < Bins_extent) {
        Bins_data[address] = value;
    }
}
#endif
#elif GLIFT_BINS != 204953009
#error the functions of another structure called Bins are included already
#endif
