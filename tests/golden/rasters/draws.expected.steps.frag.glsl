#version 460
// steps, fragment part, draws.glift:60: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

void main() {
    gl_FragDepth = gl_FragCoord.z;
    // draws.glift:63
    vec4 window = gl_FragCoord;
    gl_FragDepth = floor(window.x) * 0.0625;
}
