// Types that hold nothing: structs without fields (operators, mostly) and what is made of them only. They have no
// memory and no place in a parameter block, and shaders know nothing of them.
#pragma once

#include "ir/ir.h"

namespace gliftc::ir {

bool is_empty(const Program&, TypeId);

/// Whether the type is empty or has an empty part.
bool holds_empty(const Program&, TypeId);

}  // namespace gliftc::ir
