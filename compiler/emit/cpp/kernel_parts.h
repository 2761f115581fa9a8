// What the code of a kernel and the function that calls it share: the layout of the block of the pass's parameters.
#pragma once

#include "emit/cpp/unit.h"

namespace gliftc::cpp {

/// A parameter of a pass, and the name of its member in the struct that mirrors the block.
struct NamedParameter {
    const ir::PassParameter* parameter;
    std::string member;
};

/// The pass's parameters in the order of their offsets.
std::vector<NamedParameter> parameters_in_order(const Globals& globals, const ir::Pass& pass);

/// The struct that mirrors the parameter block, `struct <name>_parameters { … };`, and a static_assert for its size.
/// Empty without parameters.
std::string parameters_of(const Globals& globals, const ir::Pass& pass, const std::string& name);

}  // namespace gliftc::cpp
