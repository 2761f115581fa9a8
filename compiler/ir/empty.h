// Empty types: structs without fields (mostly operators, whose type selects functions), and structs and arrays whose
// fields or elements all have empty types. They have no memory and no entry in a parameter block, and are removed from
// shaders.
#pragma once

#include "ir/ir.h"

namespace gliftc::ir {

/// A cheap test, made for every expression: only structs, arrays and optionals can be empty or have empty parts.
inline bool may_be_empty(const Program& program, TypeId id) {
    const TypeKind kind = program.types.kind(id);
    return kind == TypeKind::struct_ || kind == TypeKind::array || kind == TypeKind::optional;
}

// Helpers of is_empty and holds_empty below, for types for which may_be_empty() is true.
bool is_empty_whole(const Program&, TypeId);
bool has_empty_part(const Program&, TypeId);

inline bool is_empty(const Program& program, TypeId id) {
    return may_be_empty(program, id) && is_empty_whole(program, id);
}

/// Whether the type is empty, or has a field, element or value of an empty type, at any depth.
inline bool holds_empty(const Program& program, TypeId id) {
    return may_be_empty(program, id) && has_empty_part(program, id);
}

}  // namespace gliftc::ir
