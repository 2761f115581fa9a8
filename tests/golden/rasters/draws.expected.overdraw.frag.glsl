#version 460
// overdraw, fragment part, draws.glift:49: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(push_constant, scalar) uniform Parameters {
    uint points_extent;
    uvec2 counts_extent;
};

layout(scalar, set = 0, binding = 3) buffer Counts_data { uint counts_data[]; };

// Saturates; not-a-number gives 0.
uint to_uint(float x) {
    float safe = x >= 0.0 && x < 4294967296.0 ? x : 0.0;
    return x >= 4294967296.0 ? 4294967295u : uint(safe);
}

void main() {
    uvec2 pixel = uvec2(to_uint(gl_FragCoord.x), to_uint(gl_FragCoord.y));
    // draws.glift:56
    if (all(lessThan(pixel, counts_extent))) {
        atomicAdd(counts_data[pixel.y * counts_extent.x + pixel.x], pixel.x < 3u ? 2u : 1u);
    }
}
