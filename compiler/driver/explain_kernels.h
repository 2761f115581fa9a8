// What `gliftc explain` says of kernels: of draws (`raster`), and how updates and transposed accesses of other kernels
// reach memory, and whose arithmetic is not exact.
#pragma once

#include "driver/compile.h"

#include <string>
#include <utility>
#include <vector>

namespace gliftc {

struct ExplainedKernel {
    std::string name, place;
    /// The lines about the kernel, each a heading and a text: {"draws", "triangles of corner"}.
    std::vector<std::pair<std::string, std::string>> facts;
};

/// The draws in the modules on the command line.
std::vector<ExplainedKernel> explained_draws(const Compilation& c);

/// The other kernels in the modules on the command line that write by `scatter` with an operation, if what their
/// elements write is combined before it updates memory.
std::vector<ExplainedKernel> explained_updates(const Compilation& c);

/// The kernels in the modules on the command line whose shaders load or store through a tile in workgroup memory.
std::vector<ExplainedKernel> explained_tiles(const Compilation& c);

/// The kernels in the modules on the command line that are declared @fast_math.
std::vector<ExplainedKernel> explained_arithmetic(const Compilation& c);

}  // namespace gliftc
