// What modules call the instances of structures. Several may name one, and a module may give it several names.
#pragma once

#include "ir/ir.h"

#include <vector>

namespace gliftc::ir {

/// The names under which a module makes the structure public, in their order.
std::vector<Name> public_names(const Structure& structure, std::uint32_t module);

bool is_public(const Structure& structure, std::uint32_t module);

/// What code of a module calls the structure: by the module's first public name, else by another of its own, else by
/// one that comes with what it imports. Empty: by none.
Name name_in(const Program& program, const Structure& structure, std::uint32_t module);

}  // namespace gliftc::ir
