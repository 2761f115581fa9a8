// What a draw is, for `gliftc explain`: a file and the modules that it names.
#pragma once

#include "driver/compile.h"
#include "emit/json/text.h"

#include <string>
#include <utility>
#include <vector>

namespace gliftc {

struct ExplainedDraw {
    std::string name, place;
    std::vector<std::pair<std::string, std::string>> facts;  ///< what, and how it is
};

/// Of the modules on the command line.
std::vector<ExplainedDraw> explained_draws(const Compilation& c);

}  // namespace gliftc
