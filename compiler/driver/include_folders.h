#pragma once

#include "driver/options.h"

#include <string>
#include <vector>

namespace gliftc {

struct Compilation;

/// The folders in which headers of `extern struct` may be: those of the files and of imported modules that declare one,
/// and those given by -I.
std::vector<std::string> include_folders(const Options& options, const Compilation& compilation);

}  // namespace gliftc
