// Array<1, float>, array.glift:24.
// Define VALUES_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at VALUES_BINDING + 1 + k.
// Optional: VALUES_SET (the descriptor set, else 0), VALUES_STATE (see below), VALUES_READONLY (nothing is written).
#ifndef GLIFT_VALUES
#define GLIFT_VALUES 825860513
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

layout(scalar, set = VALUES_SET, binding = VALUES_BINDING + 1) VALUES_ACCESS buffer Values_data_memory { float Values_data[]; };

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

uint Values_translate(uint address) {
    return address;
}

float Values_read(uint address) {
    bool Values_value_inside = address < Values_extent;
    float Values_value = Values_data[Values_value_inside ? address : 0u];
    return Values_value_inside ? Values_value : 0.0;
}

float Values_sample(float point) {
    float Values_lower = point - 0.5;
    float Values_corner = floor(Values_lower);
    float Values_weight = Values_lower - Values_corner;
    uint Values_base = uint(to_int(Values_corner));
    bool Values_corner0_value_inside = Values_base < Values_extent;
    float Values_corner0_value = Values_data[Values_corner0_value_inside ? Values_base : 0u];
    uint Values_corner1_address = Values_base + 1u;
    bool Values_corner1_value_inside = Values_corner1_address < Values_extent;
    float Values_corner1_value = Values_data[Values_corner1_value_inside ? Values_corner1_address : 0u];
    return blend(Values_corner0_value_inside ? Values_corner0_value : 0.0, Values_corner1_value_inside
        ? Values_corner1_value : 0.0, Values_weight);
}

#ifndef VALUES_READONLY
void Values_write(uint address, float value) {
    if (address < Values_extent) {
        Values_data[address] = value;
    }
}
#endif
#elif GLIFT_VALUES != 825860513
#error the functions of another structure called Values are included already
#endif
