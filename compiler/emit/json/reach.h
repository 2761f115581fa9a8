// What a module's reflection must contain besides what the module declares: all that these refer to.
#pragma once

#include "ir/pass.h"

#include <set>

namespace gliftc::json {

/// Indices into the program's tables.
struct Reached {
    std::set<std::uint32_t> structures, structs, enums;
};

/// Everything that the kernels and pipelines of `module` use, and what is pub in it.
Reached reach(const ir::Program& program, std::uint32_t module);

}  // namespace gliftc::json
