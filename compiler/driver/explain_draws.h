// What `gliftc explain` says of draws (`raster`).
#pragma once

#include "driver/compile.h"

#include <string>
#include <utility>
#include <vector>

namespace gliftc {

struct ExplainedDraw {
    std::string name, place;
    /// The lines about the draw, each a heading and a text: {"draws", "triangles of corner"}.
    std::vector<std::pair<std::string, std::string>> facts;
};

/// The draws in the modules on the command line.
std::vector<ExplainedDraw> explained_draws(const Compilation& c);

}  // namespace gliftc
