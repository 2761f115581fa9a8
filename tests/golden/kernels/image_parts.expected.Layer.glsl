// ImageLayer<rgba8>, image.glift:28.
// Define LAYER_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at LAYER_BINDING + 1 + k.
// Optional: LAYER_SET (the descriptor set, else 0), LAYER_STATE (see below), LAYER_READONLY (nothing is written).
#ifndef GLIFT_LAYER
#define GLIFT_LAYER 375282449
#extension GL_EXT_scalar_block_layout : require

#ifndef LAYER_SET
#define LAYER_SET 0
#endif
#ifndef LAYER_BINDING
#error define LAYER_BINDING before this file is included
#endif
#ifdef LAYER_READONLY
#define LAYER_ACCESS readonly
#else
#define LAYER_ACCESS
#endif

#ifndef LAYER_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = LAYER_SET, binding = LAYER_BINDING) readonly buffer Layer_state {
    uvec2 Layer_data_extent;
};
#endif

layout(set = LAYER_SET, binding = LAYER_BINDING + 1, rgba8) uniform LAYER_ACCESS image2D Layer_data;

uvec2 Layer_translate(uvec2 address) {
    return address;
}

vec4 Layer_read(uvec2 address) {
    bool Layer_value_inside = all(lessThan(address, Layer_data_extent));
    vec4 Layer_value = imageLoad(Layer_data, ivec2(Layer_value_inside ? address : uvec2(0u)));
    return Layer_value_inside ? Layer_value : vec4(0.0);
}

#ifndef LAYER_READONLY
void Layer_write(uvec2 address, vec4 value) {
    if (all(lessThan(address, Layer_data_extent))) {
        imageStore(Layer_data, ivec2(address), value);
    }
}
#endif
#elif GLIFT_LAYER != 375282449
#error the functions of another structure called Layer are included already
#endif
