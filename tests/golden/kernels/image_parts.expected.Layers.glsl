// ImageLayers<rgba8>, image.glift:22.
// Define LAYERS_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at LAYERS_BINDING + 1 + k.
// Optional: LAYERS_SET (the descriptor set, else 0), LAYERS_STATE (see below), LAYERS_READONLY (nothing is written).
#ifndef GLIFT_LAYERS
#define GLIFT_LAYERS 1266878079
#extension GL_EXT_scalar_block_layout : require

#ifndef LAYERS_SET
#define LAYERS_SET 0
#endif
#ifndef LAYERS_BINDING
#error define LAYERS_BINDING before this file is included
#endif
#ifdef LAYERS_READONLY
#define LAYERS_ACCESS readonly
#else
#define LAYERS_ACCESS
#endif

#ifndef LAYERS_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = LAYERS_SET, binding = LAYERS_BINDING) readonly buffer Layers_state {
    uvec2 Layers_extent;
    uint Layers_layers;
};
#endif

layout(set = LAYERS_SET, binding = LAYERS_BINDING + 1, rgba8) uniform LAYERS_ACCESS image2DArray Layers_data;

uvec3 Layers_translate(uvec3 address) {
    return address;
}

vec4 Layers_read(uvec3 address) {
    bool Layers_value_inside = all(lessThan(address, uvec3(Layers_extent, Layers_layers)));
    vec4 Layers_value = imageLoad(Layers_data, ivec3(Layers_value_inside ? address : uvec3(0u)));
    return Layers_value_inside ? Layers_value : vec4(0.0);
}

#ifndef LAYERS_READONLY
void Layers_write(uvec3 address, vec4 value) {
    if (all(lessThan(address, uvec3(Layers_extent, Layers_layers)))) {
        imageStore(Layers_data, ivec3(address), value);
    }
}
#endif
#elif GLIFT_LAYERS != 1266878079
#error the functions of another structure called Layers are included already
#endif
