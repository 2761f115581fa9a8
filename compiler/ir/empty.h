// Types that hold nothing: structs without fields (operators, mostly) and what is made of them only. They have no
// memory and no place in a parameter block, and shaders know nothing of them.
#pragma once

#include "ir/ir.h"

namespace gliftc::ir {

/// Whether it is made of other types, of which any may be empty; asked of every expression.
inline bool may_be_empty(const Program& program, TypeId id) {
    const TypeKind kind = program.types.kind(id);
    return kind == TypeKind::struct_ || kind == TypeKind::array || kind == TypeKind::optional;
}

bool is_empty_whole(const Program&, TypeId);
bool has_empty_part(const Program&, TypeId);

inline bool is_empty(const Program& program, TypeId id) {
    return may_be_empty(program, id) && is_empty_whole(program, id);
}

/// Whether the type is empty or has an empty part.
inline bool holds_empty(const Program& program, TypeId id) {
    return may_be_empty(program, id) && has_empty_part(program, id);
}

}  // namespace gliftc::ir
