// Each output texel is the input, sampled half a texel to the right of the texel's centre, plus one.
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 1) uniform sampler2D source;
layout(set = 0, binding = 2, r32f) uniform writeonly image2D target;
layout(push_constant, scalar) uniform Parameters { uint size[2]; };
void main() {
    const uvec2 at = gl_GlobalInvocationID.xy;
    if (at.x >= size[0] || at.y >= size[1]) return;
    const vec2 position = (vec2(at) + vec2(1.0, 0.5)) / vec2(size[0], size[1]);
    imageStore(target, ivec2(at), vec4(textureLod(source, position, 0.0).x + 1.0));
}
