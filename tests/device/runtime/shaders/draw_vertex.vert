// Reads vertices from a buffer and shifts them right by `shift` half widths of the viewport times the instance's index.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference : require
struct Corner { vec4 place; vec4 colour; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Corners { Corner corner[]; };
layout(set = 0, binding = 0, scalar) readonly buffer Parameters { uint corners, instances; float shift; uint unused; Corners at; };
layout(location = 0) smooth out vec4 colour;
void main() {
    const Corner c = at.corner[gl_VertexIndex];
    colour = c.colour;
    gl_Position = c.place + vec4(shift * float(gl_InstanceIndex) * c.place.w, 0.0, 0.0, 0.0);
}
