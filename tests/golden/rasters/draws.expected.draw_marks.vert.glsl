#version 460
// draw_marks, vertex part, draws.glift:34: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(location = 0) noperspective out vec2 inside;
layout(location = 1) flat out uint kind;

layout(scalar, set = 0, binding = 1) readonly buffer Corner_data { vec3 corner_data[]; };
layout(scalar, set = 0, binding = 2) readonly buffer Mark_data { vec3 mark_data[]; };

// Saturates; not-a-number gives 0.
uint to_uint(float x) {
    float safe = x >= 0.0 && x < 4294967296.0 ? x : 0.0;
    return x >= 4294967296.0 ? 4294967295u : uint(safe);
}

void main() {
    uvec2 address = uvec2(uint(gl_VertexIndex), uint(gl_InstanceIndex));
    // draws.glift:40
    vec2 value = corner_data[address.x].xy;
    inside = value;
    // draws.glift:41
    vec3 mark_data_value = mark_data[address.y];
    kind = to_uint(mark_data_value.z);
    // draws.glift:42
    gl_Position = vec4(mark_data_value.xy + 0.125 * value, 0.0, 1.0);
}
