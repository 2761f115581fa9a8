// What a kernel's code and the function that calls it both have: the block of its parameters.
#pragma once

#include "emit/cpp/unit.h"

namespace gliftc::cpp {

/// A parameter of a pass, and its name in the struct of them.
struct NamedParameter {
    const ir::PassParameter* parameter;
    std::string member;
};

/// As they follow each other in the block.
std::vector<NamedParameter> parameters_in_order(const Globals& globals, const ir::Pass& pass);

const char* form_name(ir::Form form);

/// The struct that mirrors the parameter block: `struct <name>_parameters { … };`. Empty without parameters.
std::string parameters_of(const Globals& globals, const ir::Pass& pass, const std::string& name);

}  // namespace gliftc::cpp
