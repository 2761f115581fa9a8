// `extern struct Particle from "particle.hpp";`: reads fields, offsets and size from the header by clang.
#pragma once

#include "driver/compile.h"

namespace gliftc {

/// Completes every such struct of the loaded modules; nested structs become declarations of the module, too. Headers
/// are searched beside the .glift file, then in the -I folders.
void import_structs(const Options& options, const FileSystem& files, Compilation& compilation);

}  // namespace gliftc
