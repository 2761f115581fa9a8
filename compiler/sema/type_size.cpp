#include "sema/type_size.h"

namespace gliftc::sema {

std::uint64_t numbers_in(const ir::Program& program, ir::TypeId id) {
    const ir::Type& type = program.types[id];
    switch (type.kind) {
    case ir::TypeKind::vector: return type.count;
    case ir::TypeKind::matrix: return std::uint64_t{type.count} * type.rows;
    case ir::TypeKind::array: return type.count * numbers_in(program, type.element);
    case ir::TypeKind::optional: return 1 + numbers_in(program, type.element);
    case ir::TypeKind::struct_: {
        std::uint64_t sum = 0;
        for (const ir::StructField& field : program.structs[type.index].fields) sum += numbers_in(program, field.type);
        return sum;
    }
    default: return 1;
    }
}

std::string too_many_numbers(const std::string& type, std::uint64_t numbers) {
    return type + " holds " + std::to_string(numbers) + " numbers, a type " + std::to_string(most_numbers) + " at most";
}

}  // namespace gliftc::sema
