// Heights, texture_unit.glift:12.
// Define HEIGHTS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at HEIGHTS_BINDING + 1 + k.
// Optional: HEIGHTS_SET (the descriptor set, else 0), HEIGHTS_STATE (see below), HEIGHTS_READONLY (nothing is written).
#ifndef GLIFT_HEIGHTS
#define GLIFT_HEIGHTS 937736942
#extension GL_EXT_scalar_block_layout : require

#ifndef HEIGHTS_SET
#define HEIGHTS_SET 0
#endif
#ifndef HEIGHTS_BINDING
#error define HEIGHTS_BINDING before this file is included
#endif
#ifdef HEIGHTS_READONLY
#define HEIGHTS_ACCESS readonly
#else
#define HEIGHTS_ACCESS
#endif

#ifndef HEIGHTS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = HEIGHTS_SET, binding = HEIGHTS_BINDING) readonly buffer Heights_state {
    uvec2 Heights_extent;
};
#endif

layout(set = HEIGHTS_SET, binding = HEIGHTS_BINDING + 1, r32f) uniform HEIGHTS_ACCESS image2D Heights_data;

uvec2 Heights_translate(uvec2 address) {
    return address;
}

float Heights_read(uvec2 address) {
    bool Heights_value_inside = all(lessThan(address, Heights_extent));
    float Heights_value = imageLoad(Heights_data, ivec2(Heights_value_inside ? address : uvec2(0u))).x;
    return Heights_value_inside ? Heights_value : 0.0;
}

#ifndef HEIGHTS_READONLY
void Heights_write(uvec2 address, float value) {
    if (all(lessThan(address, Heights_extent))) {
        imageStore(Heights_data, ivec2(address), vec4(value));
    }
}
#endif
#elif GLIFT_HEIGHTS != 937736942
#error the functions of another structure called Heights are included already
#endif
