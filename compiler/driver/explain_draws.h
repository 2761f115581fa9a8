// What `gliftc explain` says of draws (`raster`).
#pragma once

#include "driver/compile.h"

#include <string>
#include <utility>
#include <vector>

namespace gliftc {

struct ExplainedDraw {
    std::string name, place;
    /// What is said of the draw, such as {"draws", "triangles of corner"}.
    std::vector<std::pair<std::string, std::string>> facts;
};

/// The draws in the modules on the command line.
std::vector<ExplainedDraw> explained_draws(const Compilation& c);

}  // namespace gliftc
