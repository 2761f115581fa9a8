// Array<1, uint>, array.glift:24.
// Define LINE_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at LINE_BINDING + 1 + k.
// Optional: LINE_SET (the descriptor set, else 0), LINE_STATE (see below), LINE_READONLY (nothing is written).
#ifndef GLIFT_LINE
#define GLIFT_LINE 577865505
#extension GL_EXT_scalar_block_layout : require

#ifndef LINE_SET
#define LINE_SET 0
#endif
#ifndef LINE_BINDING
#error define LINE_BINDING before this file is included
#endif
#ifdef LINE_READONLY
#define LINE_ACCESS readonly
#else
#define LINE_ACCESS
#endif

#ifndef LINE_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = LINE_SET, binding = LINE_BINDING) readonly buffer Line_state {
    uint Line_extent;
};
#endif

layout(scalar, set = LINE_SET, binding = LINE_BINDING + 1) LINE_ACCESS buffer Line_data_memory { uint Line_data[]; };

uint Line_translate(uint address) {
    return address;
}

uint Line_read(uint address) {
    bool Line_value_inside = address < Line_extent;
    uint Line_value = Line_data[Line_value_inside ? address : 0u];
    return Line_value_inside ? Line_value : 0u;
}

#ifndef LINE_READONLY
void Line_write(uint address, uint value) {
    if (address < Line_extent) {
        Line_data[address] = value;
    }
}
#endif
#elif GLIFT_LINE != 577865505
#error the functions of another structure called Line are included already
#endif
