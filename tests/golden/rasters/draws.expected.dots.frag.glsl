#version 460
// dots, fragment part, draws.glift:74: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(location = 0) out vec4 image;

void main() {
    // draws.glift:79
    image = vec4(0.125);
}
