#version 460
// draw_marks, fragment part, draws.glift:34: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(location = 0) noperspective in vec2 inside;
layout(location = 1) flat in uint kind;
layout(location = 0) out vec4 image;

void main() {
    // draws.glift:45
    image = vec4(inside, float(kind), 0.5) * (gl_FrontFacing ? 1.0 : 0.5);
}
