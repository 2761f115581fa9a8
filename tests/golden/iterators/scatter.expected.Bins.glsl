#ifndef GLIFT_BINS
#define GLIFT_BINS
// Array<1, uint, none, buffer>, array.glift:20.
// Define before including: BINS_SET, BINS_BINDING (the state; memory k follows at + 1 + k), BINS_STATE, BINS_READONLY.
#extension GL_EXT_scalar_block_layout : require

#ifndef BINS_SET
#define BINS_SET 0
#endif
#ifndef BINS_BINDING
#define BINS_BINDING 0
#endif
#ifdef BINS_READONLY
#define BINS_ACCESS readonly
#else
#define BINS_ACCESS
#endif

#ifndef BINS_STATE  // define it where the members below are declared in a block of your own
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
#endif
