// Array<1, uint>, array.glift:24.
// Define NUMBERS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at NUMBERS_BINDING + 1 + k.
// Optional: NUMBERS_SET (the descriptor set, else 0), NUMBERS_STATE (see below), NUMBERS_READONLY (nothing is written).
#ifndef GLIFT_NUMBERS
#define GLIFT_NUMBERS 727790397
#extension GL_EXT_scalar_block_layout : require

#ifndef NUMBERS_SET
#define NUMBERS_SET 0
#endif
#ifndef NUMBERS_BINDING
#error define NUMBERS_BINDING before this file is included
#endif
#ifdef NUMBERS_READONLY
#define NUMBERS_ACCESS readonly
#else
#define NUMBERS_ACCESS
#endif

#ifndef NUMBERS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = NUMBERS_SET, binding = NUMBERS_BINDING) readonly buffer Numbers_state {
    uint Numbers_extent;
};
#endif

layout(scalar, set = NUMBERS_SET, binding = NUMBERS_BINDING + 1) NUMBERS_ACCESS buffer Numbers_data_memory { uint Numbers_data[]; };

uint Numbers_translate(uint address) {
    return address;
}

uint Numbers_read(uint address) {
    bool Numbers_value_inside = address < Numbers_extent;
    uint Numbers_value = Numbers_data[Numbers_value_inside ? address : 0u];
    return Numbers_value_inside ? Numbers_value : 0u;
}

#ifndef NUMBERS_READONLY
void Numbers_write(uint address, uint value) {
    if (address < Numbers_extent) {
        Numbers_data[address] = value;
    }
}
#endif
#elif GLIFT_NUMBERS != 727790397
#error the functions of another structure called Numbers are included already
#endif
