// The names that modules give to an instance of a structure (several modules may name it, and one module more than
// once), and its public functions.
#pragma once

#include "ir/ir.h"

#include <vector>

namespace gliftc::ir {

/// The public names that the module gives to the structure, in the order of Structure::aliases.
std::vector<Name> public_names(const Structure& structure, ModuleId module);

bool is_public(const Structure& structure, ModuleId module);

/// The name of the structure in a module: the first public name that the module gives it, else its first private one,
/// else the first name, public or private, from a module that it imports directly or through others. An empty Name if
/// no such module names the structure.
Name name_in(const Program& program, const Structure& structure, ModuleId module);

/// The public functions with exactly one parameter that is a structure or container, namely this one: first
/// Structure::methods, which C++ can call, then others of Program::functions. Of several with the same key and the same
/// parameter types only the first.
std::vector<FunctionId> public_functions(const Program& program, StructureId structure);

}  // namespace gliftc::ir
