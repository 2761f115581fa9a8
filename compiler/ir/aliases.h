// Names that modules give to instances of structures: several modules may name one, and a module may name it twice.
#pragma once

#include "ir/ir.h"

#include <vector>

namespace gliftc::ir {

/// The public names that a module gives to the structure, in order.
std::vector<Name> public_names(const Structure& structure, std::uint32_t module);

bool is_public(const Structure& structure, std::uint32_t module);

/// The name of the structure in a module: the module's first public name for it, else another of its own, else an
/// imported one. Empty if it has none.
Name name_in(const Program& program, const Structure& structure, std::uint32_t module);

}  // namespace gliftc::ir
