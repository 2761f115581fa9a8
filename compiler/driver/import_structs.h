// `extern struct Particle from "particle.hpp";`: fields, offsets and size come from the header, by clang.
#pragma once

#include "driver/compile.h"

namespace gliftc {

/// Completes every such struct of the loaded modules; the structs that it contains become declarations of the module
/// too. Headers are looked for beside the .glift file, then in the -I folders.
void import_structs(const Options& options, const FileSystem& files, Compilation& compilation);

}  // namespace gliftc
