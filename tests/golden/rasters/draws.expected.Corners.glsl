// Array<1, uint>, array.glift:24.
// Define CORNERS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at CORNERS_BINDING + 1 + k.
// Optional: CORNERS_SET (the descriptor set, else 0), CORNERS_STATE (see below), CORNERS_READONLY (nothing is written).
#ifndef GLIFT_CORNERS
#define GLIFT_CORNERS 667914925
#extension GL_EXT_scalar_block_layout : require

#ifndef CORNERS_SET
#define CORNERS_SET 0
#endif
#ifndef CORNERS_BINDING
#error define CORNERS_BINDING before this file is included
#endif
#ifdef CORNERS_READONLY
#define CORNERS_ACCESS readonly
#else
#define CORNERS_ACCESS
#endif

#ifndef CORNERS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = CORNERS_SET, binding = CORNERS_BINDING) readonly buffer Corners_state {
    uint Corners_extent;
};
#endif

layout(scalar, set = CORNERS_SET, binding = CORNERS_BINDING + 1) CORNERS_ACCESS buffer Corners_data_memory { uint Corners_data[]; };

uint Corners_translate(uint address) {
    return address;
}

uint Corners_read(uint address) {
    bool Corners_value_inside = address < Corners_extent;
    uint Corners_value = Corners_data[Corners_value_inside ? address : 0u];
    return Corners_value_inside ? Corners_value : 0u;
}

#ifndef CORNERS_READONLY
void Corners_write(uint address, uint value) {
    if (address < Corners_extent) {
        Corners_data[address] = value;
    }
}
#endif
#elif GLIFT_CORNERS != 667914925
#error the functions of another structure called Corners are included already
#endif
