// Array<1, float3, none, buffer>, array.glift:20.
// Define POINTS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at POINTS_BINDING + 1 + k.
// Optional: POINTS_SET (the descriptor set, else 0), POINTS_STATE (see below), POINTS_READONLY (nothing is written).
#ifndef GLIFT_POINTS
#define GLIFT_POINTS 646964856
#extension GL_EXT_scalar_block_layout : require

#ifndef POINTS_SET
#define POINTS_SET 0
#endif
#ifndef POINTS_BINDING
#error define POINTS_BINDING before this file is included
#endif
#ifdef POINTS_READONLY
#define POINTS_ACCESS readonly
#else
#define POINTS_ACCESS
#endif

#ifndef POINTS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = POINTS_SET, binding = POINTS_BINDING) readonly buffer Points_state {
    uint Points_extent;
};
#endif

layout(scalar, set = POINTS_SET, binding = POINTS_BINDING + 1) POINTS_ACCESS buffer Points_data_memory { vec3 Points_data[]; };

uint Points_translate(uint address) {
    return address;
}

vec3 Points_read(uint address) {
    bool Points_value_inside = address < Points_extent;
    vec3 Points_value = Points_data[Points_value_inside ? address : 0u];
    return Points_value_inside ? Points_value : vec3(0.0);
}

#ifndef POINTS_READONLY
void Points_write(uint address, vec3 value) {
    if (address < Points_extent) {
        Points_data[address] = value;
    }
}
#endif
#elif GLIFT_POINTS != 646964856
#error the functions of another structure called Points are included already
#endif
