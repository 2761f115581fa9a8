#include "ir/empty.h"

#include <algorithm>

namespace gliftc::ir {

bool is_empty_whole(const Program& program, TypeId id) {
    const Type& type = program.types[id];
    if (type.kind == TypeKind::array) return is_empty(program, type.element);
    if (type.kind != TypeKind::struct_) return false;
    const auto& fields = program.structs[type.struct_].fields;
    return std::all_of(fields.begin(), fields.end(),
                       [&](const StructField& field) { return is_empty(program, field.type); });
}

bool has_empty_part(const Program& program, TypeId id) {
    const Type& type = program.types[id];
    if (type.kind == TypeKind::array || type.kind == TypeKind::optional) return holds_empty(program, type.element);
    if (type.kind != TypeKind::struct_) return false;
    const auto& fields = program.structs[type.struct_].fields;
    return fields.empty() || std::any_of(fields.begin(), fields.end(),
                                         [&](const StructField& field) { return holds_empty(program, field.type); });
}

}  // namespace gliftc::ir
