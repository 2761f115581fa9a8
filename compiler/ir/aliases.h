// Names that modules give to instances of structures: several modules may name one, and a module may name it twice.
#pragma once

#include "ir/ir.h"

#include <vector>

namespace gliftc::ir {

/// The public names that a module gives to the structure, in the order of its source.
std::vector<Name> public_names(const Structure& structure, std::uint32_t module);

bool is_public(const Structure& structure, std::uint32_t module);

/// The name of the structure in a module: the first public name that the module gives it, else its first private one,
/// else the first name, public or private, from a module that it imports directly or through others. Empty if there is
/// none.
Name name_in(const Program& program, const Structure& structure, std::uint32_t module);

/// The public functions of a structure or adaptor, those whose only structure it is, each once: first the methods that
/// C++ calls, then the others that the program uses.
std::vector<FunctionId> public_functions(const Program& program, std::uint32_t structure);

}  // namespace gliftc::ir
