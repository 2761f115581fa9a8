// The structures, structs and enums that a module's reflection must contain.
#pragma once

#include "ir/pass.h"

#include <set>

namespace gliftc::json {

struct Reached {
    std::set<ir::StructureId> structures;
    std::set<ir::StructId> structs;
    std::set<ir::EnumId> enums;
};

/// The structures, structs and enums that the kernels and pipelines of `module` take or give, those that are public in
/// it, and all that these consist of.
Reached reach(const ir::Program& program, ir::ModuleId module);

}  // namespace gliftc::json
