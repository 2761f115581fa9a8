// SPIR-V from GLSL, in process: glslang, corrections of its result (exact.h, alignment.h), the optimiser on request,
// the validator.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gliftc::spirv {

enum class Optimise : std::uint8_t { no, size };
/// Whether a device may fuse a multiplication with an addition.
enum class Contraction : std::uint8_t { off, on };
enum class Stage : std::uint8_t { compute, vertex, fragment };

struct Spirv {
    std::vector<std::uint32_t> words;  ///< empty if there is an error
    std::string error;                 ///< what glslang or the validator said; it is a fault of this compiler
};

/// A shader for Vulkan 1.3. The code that is left after optimisation keeps its names and, where the GLSL has `#line`,
/// its source lines. min and max of a number and a NaN give the number, and clamp
/// is min(max(x, low), high). Safe to call from several threads.
Spirv spirv_of(const std::string& glsl, Optimise optimise = Optimise::no, Stage stage = Stage::compute,
               Contraction contraction = Contraction::off);

}  // namespace gliftc::spirv
