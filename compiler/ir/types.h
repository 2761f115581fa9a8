// Interned types: two types are equal if and only if their ids are.
#pragma once

#include "base/arena.h"
#include "base/name.h"

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace gliftc::ir {

struct Struct;
struct Enum;
struct Structure;
using StructId = Id<Struct>;
using EnumId = Id<Enum>;
using StructureId = Id<Structure>;

enum class TypeKind : std::uint8_t {
    error,  // the type of wrong code, which has been reported; compatible with every type
    void_,
    bool_,
    int_,
    uint,
    float_,
    half,
    double_,
    int64,
    uint64,     // the last of the scalars
    vector,     // element × count (2, 3, 4)
    matrix,     // element × columns (count) × rows (rows)
    array,      // element × count
    struct_,    // Type::struct_
    enum_,      // Type::enum_; its values are uints
    optional,   // element?
    structure,  // an instance of a structure: Type::structure
    slice,      // only in pipelines: a box of a structure (element is the structure type)
    device,     // only in pipelines: a value of type `element` that is on the device; `await` reads it back
};

struct Type;
using TypeId = Id<Type>;

struct Type {
    TypeKind kind = TypeKind::error;
    TypeId element{};
    std::uint32_t count = 0;
    std::uint32_t rows = 0;
    StructId struct_;
    EnumId enum_;
    StructureId structure;
    bool operator==(const Type&) const = default;
};

/// All types of one program. The scalar ids are fixed members.
class Types {
public:
    Types();

    const Type& operator[](TypeId id) const { return arena_[id]; }

    TypeId error, void_, bool_, int_, uint, float_, half, double_, int64, uint64;

    TypeId vector(TypeId element, std::uint32_t count);  ///< count 1 is the element itself
    TypeId matrix(TypeId element, std::uint32_t columns, std::uint32_t rows);
    TypeId array(TypeId element, std::uint32_t count);
    TypeId optional(TypeId element);
    TypeId slice(TypeId structure);
    TypeId device(TypeId element);
    TypeId of_struct(StructId id);
    TypeId of_enum(EnumId id);
    TypeId of_structure(StructureId id);

    /// The id in this table of the type that has the id `id` in `other`. `other` is the table of another program, whose
    /// structs, enums and structures have the same ids.
    TypeId same_as(const Types& other, TypeId id);

    TypeId intern(Type type);
    TypeId find(const Type& type) const;  ///< `error` if the type was not interned yet

    std::uint32_t size() const { return arena_.size(); }
    TypeKind kind(TypeId id) const { return arena_[id].kind; }
    /// Kinds from bool_ to uint64.
    bool is_scalar(TypeId id) const { return kind(id) >= TypeKind::bool_ && kind(id) <= TypeKind::uint64; }
    bool is_number(TypeId id) const { return is_scalar(id) && id != bool_; }
    bool is_integer(TypeId id) const { return id == int_ || id == uint || id == int64 || id == uint64; }
    bool is_signed(TypeId id) const { return id == int_ || id == int64; }
    bool is_floating(TypeId id) const { return id == float_ || id == half || id == double_; }
    bool is_vector(TypeId id) const { return kind(id) == TypeKind::vector; }
    bool is_matrix(TypeId id) const { return kind(id) == TypeKind::matrix; }
    /// The element of a vector or matrix, else the type itself.
    TypeId scalar_of(TypeId id) const {
        const Type& type = arena_[id];
        return type.kind == TypeKind::vector || type.kind == TypeKind::matrix ? type.element : id;
    }
    /// The number of a vector's components; 1 for a scalar.
    std::uint32_t components(TypeId id) const { return is_vector(id) ? arena_[id].count : 1; }
    TypeId with_scalar(TypeId shape, TypeId scalar);  ///< the shape with other scalars: bool4 from (float4, bool)

private:
    Arena<Type> arena_;
    std::unordered_map<std::uint64_t, std::vector<TypeId>> index_;
};

}  // namespace gliftc::ir
