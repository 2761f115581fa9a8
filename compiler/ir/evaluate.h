// Compile-time values, and the interpreter that computes them from expressions and functions that access no structures.
#pragma once

#include "ir/ir.h"

#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace gliftc::ir {

/// One scalar: `bits` for bool, integers (sign- or zero-extended to 64 bits) and enums, `number` for floating types.
struct Lane {
    std::uint64_t bits = 0;
    double number = 0;
    bool operator==(const Lane&) const = default;
};

/// A value of a scalar, enum, vector, matrix, array, struct or optional type: its scalars one after the other, those of
/// a matrix by columns. An optional has its flag first, then the value's lanes (zeros for none).
struct Value {
    TypeId type;
    SmallVector<Lane, 4> lanes;
    bool operator==(const Value&) const = default;

    std::uint64_t bits() const { return lanes.empty() ? 0 : lanes[0].bits; }
};

/// How many scalars a value of the type has.
std::size_t lane_count(const Program& program, TypeId type);

/// The value of `expr`. Absent if the interpreter cannot compute it: it is not a compile-time constant, uses an
/// operation that the interpreter does not have (such as `sin`), or takes over a million steps or over 200 nested
/// calls.
std::optional<Value> evaluate(const Program& program, ExprId expr);

/// Initialisers of immutable locals.
using Definitions = std::unordered_map<LocalId, ExprId>;

/// As above; the value of a local is that of its expression in `definitions`.
std::optional<Value> evaluate(const Program& program, ExprId expr, const Definitions& definitions);

/// Gives the values of operations that the interpreter cannot compute itself, since they depend on the context (state,
/// member, memory_extent, domain, …); absent if the value is not known.
using Surroundings = std::function<std::optional<Value>(const Expr&)>;

/// The value of `expr`, with the values that `surroundings` gives.
std::optional<Value> evaluate(const Program& program, ExprId expr, const Surroundings& surroundings);

/// The result of a function for these arguments; absent if the interpreter cannot compute it, as for evaluate().
std::optional<Value> call(const Program& program, FunctionId function, std::vector<Value> arguments,
                          const Surroundings& surroundings);

/// Makes an expression with this value: a constant, or one that is built of constants.
ExprId materialize(Program& program, const Value& value, Span span);
/// The value of the type whose scalars are all zero, by which `var x: T;` begins.
ExprId zero(Program& program, TypeId type, Span span);

/// The value of a scalar, vector or matrix much as the language writes it: 4, 1.5, uint2(8, 8); of an enum, the name of
/// the enumerator alone. Of other types, the type and the scalars in parentheses (of one scalar, only the scalar),
/// floats among these as 0.
std::string to_text(const Program& program, const Value& value);

/// The name of a type as written in the language: uint3, float?, Array<4, float>. Types that cannot be written so are
/// described: nothing, slice of Field, uint on the device.
std::string to_text(const Program& program, TypeId type);
/// The same with the modules of structs, enums and structures: std.array.Array<4, float>.
std::string to_qualified_text(const Program& program, TypeId type);
/// The name of a module and a dot: `std.array.`
std::string module_text(const Program& program, ModuleId module);

/// One scalar operation with the exact semantics of the language (wraparound, float rounding, defined division by
/// zero).
Lane apply(const Types& types, BinaryOp op, TypeId operand_type, Lane a, Lane b);
/// The lane rounded or wrapped to what a scalar of the type can hold.
Lane normalize(const Types& types, TypeId scalar, Lane lane);
Lane convert(const Types& types, TypeId from, TypeId to, Lane lane);

}  // namespace gliftc::ir
