// Array<1, uint>, array.glift:24.
// Define SAMPLES_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at SAMPLES_BINDING + 1 + k.
// Optional: SAMPLES_SET (the descriptor set, else 0), SAMPLES_STATE (see below), SAMPLES_READONLY (nothing is written).
#ifndef GLIFT_SAMPLES
#define GLIFT_SAMPLES 1196286467
#extension GL_EXT_scalar_block_layout : require

#ifndef SAMPLES_SET
#define SAMPLES_SET 0
#endif
#ifndef SAMPLES_BINDING
#error define SAMPLES_BINDING before this file is included
#endif
#ifdef SAMPLES_READONLY
#define SAMPLES_ACCESS readonly
#else
#define SAMPLES_ACCESS
#endif

#ifndef SAMPLES_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = SAMPLES_SET, binding = SAMPLES_BINDING) readonly buffer Samples_state {
    uint Samples_extent;
};
#endif

layout(scalar, set = SAMPLES_SET, binding = SAMPLES_BINDING + 1) SAMPLES_ACCESS buffer Samples_data_memory { uint Samples_data[]; };

uint Samples_translate(uint address) {
    return address;
}

uint Samples_read(uint address) {
    bool Samples_value_inside = address < Samples_extent;
    uint Samples_value = Samples_data[Samples_value_inside ? address : 0u];
    return Samples_value_inside ? Samples_value : 0u;
}

#ifndef SAMPLES_READONLY
void Samples_write(uint address, uint value) {
    if (address < Samples_extent) {
        Samples_data[address] = value;
    }
}
#endif
#elif GLIFT_SAMPLES != 1196286467
#error the functions of another structure called Samples are included already
#endif
