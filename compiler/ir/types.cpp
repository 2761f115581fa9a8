#include "ir/types.h"

namespace gliftc::ir {

namespace {

std::uint64_t hash_of(const Type& type) {
    std::uint64_t hash = static_cast<std::uint64_t>(type.kind);
    for (std::uint32_t part :
         {type.element.index, type.count, type.rows, type.struct_.index, type.enum_.index, type.structure.index})
        hash = (hash ^ part) * 0x9e3779b97f4a7c15ull + (hash >> 29);
    return hash;
}

}  // namespace

Types::Types() {
    error = intern({.kind = TypeKind::error});
    void_ = intern({.kind = TypeKind::void_});
    bool_ = intern({.kind = TypeKind::bool_});
    int_ = intern({.kind = TypeKind::int_});
    uint = intern({.kind = TypeKind::uint});
    float_ = intern({.kind = TypeKind::float_});
    half = intern({.kind = TypeKind::half});
    double_ = intern({.kind = TypeKind::double_});
    int64 = intern({.kind = TypeKind::int64});
    uint64 = intern({.kind = TypeKind::uint64});
}

TypeId Types::intern(Type type) {
    auto& bucket = index_[hash_of(type)];
    for (TypeId id : bucket)
        if (arena_[id] == type) return id;
    bucket.push_back(arena_.add(type));
    return bucket.back();
}

TypeId Types::find(const Type& type) const {
    const auto bucket = index_.find(hash_of(type));
    if (bucket == index_.end()) return error;
    for (TypeId id : bucket->second)
        if (arena_[id] == type) return id;
    return error;
}

TypeId Types::vector(TypeId element, std::uint32_t count) {
    if (count == 1) return element;
    return intern({.kind = TypeKind::vector, .element = element, .count = count});
}

TypeId Types::matrix(TypeId element, std::uint32_t columns, std::uint32_t rows) {
    return intern({.kind = TypeKind::matrix, .element = element, .count = columns, .rows = rows});
}

TypeId Types::array(TypeId element, std::uint32_t count) {
    return intern({.kind = TypeKind::array, .element = element, .count = count});
}

TypeId Types::optional(TypeId element) { return intern({.kind = TypeKind::optional, .element = element}); }
TypeId Types::slice(TypeId structure) { return intern({.kind = TypeKind::slice, .element = structure}); }
TypeId Types::device(TypeId element) { return intern({.kind = TypeKind::device, .element = element}); }
TypeId Types::of_struct(StructId id) { return intern({.kind = TypeKind::struct_, .struct_ = id}); }
TypeId Types::of_enum(EnumId id) { return intern({.kind = TypeKind::enum_, .enum_ = id}); }
TypeId Types::of_structure(StructureId id) { return intern({.kind = TypeKind::structure, .structure = id}); }

TypeId Types::same_as(const Types& other, TypeId id) {
    Type type = other[id];
    if (type.element) type.element = same_as(other, type.element);
    return intern(type);
}

TypeId Types::with_scalar(TypeId shape, TypeId scalar) {
    const Type type = arena_[shape];
    if (type.kind == TypeKind::vector) return vector(scalar, type.count);
    if (type.kind == TypeKind::matrix) return matrix(scalar, type.count, type.rows);
    return scalar;
}

}  // namespace gliftc::ir
