// `extern struct Particle from "particle.hpp";`: reads fields, offsets and size from the header by clang.
#pragma once

#include "driver/compile.h"

namespace gliftc {

/// Completes every `extern struct` of the loaded modules. Structs that are the types of its fields become declarations
/// of the module, too. Headers are looked for beside the .glift file, then in the -I folders. Reports an error if a
/// header is not found, if clang cannot read the struct from it, if shaders cannot use the struct, or if the name of a
/// field's struct means something else in the module.
void import_structs(const Options& options, const FileSystem& files, Compilation& compilation);

}  // namespace gliftc
