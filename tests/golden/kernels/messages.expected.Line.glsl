// Array<1, float>, array.glift:24.
// Define LINE_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at LINE_BINDING + 1 + k.
// Optional: LINE_SET (the descriptor set, else 0), LINE_STATE (see below), LINE_READONLY (nothing is written).
#ifndef GLIFT_LINE
#define GLIFT_LINE 1835466113
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

layout(scalar, set = LINE_SET, binding = LINE_BINDING + 1) LINE_ACCESS buffer Line_data_memory { float Line_data[]; };

#ifndef GLIFT_HELPER_722867247
#define GLIFT_HELPER_722867247
// Saturates; not-a-number gives 0.
int to_int(float x) {
    float safe = x >= -2147483648.0 && x < 2147483648.0 ? x : 0.0;
    return x >= 2147483648.0 ? 2147483647 : x < -2147483648.0 ? int(0x80000000u) : int(safe);
}
#endif

#ifndef GLIFT_HELPER_204653774
#define GLIFT_HELPER_204653774
float blend(float x, float y, float a) {
    return x * (float(1.0) - a) + y * a;
}
#endif

uint Line_translate(uint address) {
    return address;
}

float Line_read(uint address) {
    bool Line_value_inside = address < Line_extent;
    float Line_value = Line_data[Line_value_inside ? address : 0u];
    return Line_value_inside ? Line_value : 0.0;
}

float Line_sample(float point) {
    float Line_lower = point - 0.5;
    float Line_corner = floor(Line_lower);
    float Line_weight = Line_lower - Line_corner;
    uint Line_base = uint(to_int(Line_corner));
    bool Line_corner0_value_inside = Line_base < Line_extent;
    float Line_corner0_value = Line_data[Line_corner0_value_inside ? Line_base : 0u];
    uint Line_corner1_address = Line_base + 1u;
    bool Line_corner1_value_inside = Line_corner1_address < Line_extent;
    float Line_corner1_value = Line_data[Line_corner1_value_inside ? Line_corner1_address : 0u];
    return blend(Line_corner0_value_inside ? Line_corner0_value : 0.0, Line_corner1_value_inside
        ? Line_corner1_value : 0.0, Line_weight);
}

#ifndef LINE_READONLY
void Line_write(uint address, float value) {
    if (address < Line_extent) {
        Line_data[address] = value;
    }
}
#endif
#elif GLIFT_LINE != 1835466113
#error the functions of another structure called Line are included already
#endif
