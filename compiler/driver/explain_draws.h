// What `gliftc explain` says of draws (`raster`).
#pragma once

#include "driver/compile.h"
#include "emit/json/text.h"

#include <string>
#include <utility>
#include <vector>

namespace gliftc {

struct ExplainedDraw {
    std::string name, place;
    std::vector<std::pair<std::string, std::string>>
        facts;  ///< what is said of the draw: {"draws", "triangles of corner"}
};

/// The draws in the modules on the command line.
std::vector<ExplainedDraw> explained_draws(const Compilation& c);

}  // namespace gliftc
