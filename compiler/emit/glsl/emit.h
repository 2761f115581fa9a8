// GLSL: a compute shader for one lowered kernel, or one of the two shaders of a draw.
#pragma once

#include "ir/pass.h"
#include "source/source.h"

#include <string>

namespace gliftc::glsl {

/// How the shader says which source line a statement comes from.
enum class LineMarks : std::uint8_t {
    comments,    ///< `// laplacian.glift:9` where the line changes: for reading
    directives,  ///< `#line 9 "laplacian.glift"` before each statement: for glslang's errors and debug information
};

/// How `/` and `sqrt` of floats and halves are rounded.
enum class Rounding : std::uint8_t {
    device,   ///< as the device rounds them: on some devices quotients are up to 2.5 units in the last place off
    correct,  ///< correctly: by added code, or by the device where specialisation constant 100 is true (the default)
};

struct Options {
    LineMarks lines = LineMarks::comments;
    Rounding rounding = Rounding::device;
    ir::Part part = ir::Part::vertex;  ///< of a draw: the part whose shader is printed
};

/// The shader of `pass`, or for a draw the shader of the part options.part. Its descriptor set 0 has pass.bindings[k]
/// at binding k + 1 (in the general form buffers are reached by address instead), and the status record, if the pass
/// has one, at binding pass.bindings.size() + 1. Parameters are push constants or, where !pass.push_constants, a
/// uniform or storage buffer at binding 0. Offsets are those of GL_EXT_scalar_block_layout.
std::string glsl_of(const ir::Program& program, const Sources& sources, const ir::Pass& pass,
                    const Options& options = {});

}  // namespace gliftc::glsl
