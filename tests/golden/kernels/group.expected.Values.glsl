// Array<1, uint>, array.glift:24.
// Define VALUES_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at VALUES_BINDING + 1 + k.
// Optional: VALUES_SET (the descriptor set, else 0), VALUES_STATE (see below), VALUES_READONLY (nothing is written).
#ifndef GLIFT_VALUES
#define GLIFT_VALUES 545566925
#extension GL_EXT_scalar_block_layout : require

#ifndef VALUES_SET
#define VALUES_SET 0
#endif
#ifndef VALUES_BINDING
#error define VALUES_BINDING before this file is included
#endif
#ifdef VALUES_READONLY
#define VALUES_ACCESS readonly
#else
#define VALUES_ACCESS
#endif

#ifndef VALUES_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = VALUES_SET, binding = VALUES_BINDING) readonly buffer Values_state {
    uint Values_extent;
};
#endif

layout(scalar, set = VALUES_SET, binding = VALUES_BINDING + 1) VALUES_ACCESS buffer Values_data_memory { uint Values_data[]; };

uint Values_translate(uint address) {
    return address;
}

uint Values_read(uint address) {
    bool Values_value_inside = address < Values_extent;
    uint Values_value = Values_data[Values_value_inside ? address : 0u];
    return Values_value_inside ? Values_value : 0u;
}

#ifndef VALUES_READONLY
void Values_write(uint address, uint value) {
    if (address < Values_extent) {
        Values_data[address] = value;
    }
}
#endif
#elif GLIFT_VALUES != 545566925
#error the functions of another structure called Values are included already
#endif
