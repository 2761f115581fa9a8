#version 460
// even, fragment part, draws.glift:67: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(location = 0) out vec4 image;

layout(push_constant, scalar) uniform Parameters {
    float factor;
    vec2 factor_2;
};

void main() {
    // draws.glift:70
    image = vec4(dFdxFine(3.0), dFdyFine(factor), fwidthFine(factor_2));
}
