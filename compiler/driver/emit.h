// Runs the printers of the selected targets over the modules on the command line, and names the output files.
#pragma once

#include "driver/compile.h"

namespace gliftc {

/// The outputs of the modules on the command line for the selected targets. Throws std::runtime_error if generated GLSL
/// is invalid, if clang cannot format the C++ (--style), or if two files on the command line have one name.
std::vector<Output> emit(const Options& options, const Compilation& compilation);

/// Reports an error if --style is given and clang-format does not accept the style, or cannot be loaded.
void check_style(const Options& options, Diagnostics& diagnostics);

}  // namespace gliftc
