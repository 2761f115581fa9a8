#include "sema/types/type_size.h"

#include <algorithm>

namespace gliftc::sema {

std::uint64_t scalars_in(const ir::Program& program, ir::TypeId id) {
    const ir::Type& type = program.types[id];
    switch (type.kind) {
    case ir::TypeKind::vector: return type.count;
    case ir::TypeKind::matrix: return std::uint64_t{type.count} * type.rows;
    case ir::TypeKind::array: return type.count * scalars_in(program, type.element);
    case ir::TypeKind::optional: return 1 + scalars_in(program, type.element);
    case ir::TypeKind::struct_: {
        std::uint64_t sum = 0;
        for (const ir::StructField& field : program.structs[type.struct_].fields)
            sum += scalars_in(program, field.type);
        return sum;
    }
    default: return 1;
    }
}

std::uint32_t levels_of(const ir::Program& program, ir::TypeId id) {
    const ir::Type& type = program.types[id];
    if (type.kind == ir::TypeKind::array || type.kind == ir::TypeKind::optional)
        return 1 + levels_of(program, type.element);
    if (type.kind != ir::TypeKind::struct_) return 0;
    std::uint32_t inner = 0;
    for (const ir::StructField& field : program.structs[type.struct_].fields)
        inner = std::max(inner, levels_of(program, field.type));
    return 1 + inner;
}

std::string too_many_scalars(const std::string& type, std::uint64_t scalars) {
    return type + " has " + std::to_string(scalars) + " scalars, the limit is " + std::to_string(most_scalars);
}

}  // namespace gliftc::sema
