// The type of an operation as implied by its operands, or by the function, field or binding that it names. The text of
// a lowered pass (print.h) gives a type only where the actual one differs or none is implied, and for operations that
// are spelt with their type, such as conversions.
#pragma once

#include "ir/pass.h"

namespace gliftc::ir {

/// Types::error if none is implied. `intern` returns the TypeId of a Type; where that was not interned yet, a new one
/// (read.h) or Types::error (print.h).
template <class Intern>
TypeId implied_type(const Program& program, const Pass* pass, const Expr& node, Intern&& intern) {
    const Types& types = program.types;
    const auto type = [&](std::size_t i) { return program.exprs[node.operands[i]].type; };
    const auto shaped = [&](TypeId shape, TypeId scalar) {
        if (!types.is_vector(shape)) return scalar;
        return intern(Type{.kind = TypeKind::vector, .element = scalar, .count = types.components(shape)});
    };
    const auto vector = [&](TypeId scalar, std::uint32_t count) {
        return intern(Type{.kind = TypeKind::vector, .element = scalar, .count = count});
    };
    switch (node.op) {
    case Op::unary: return type(0);
    case Op::binary:
        if (node.binary >= BinaryOp::less && node.binary <= BinaryOp::not_equal) return types.bool_;
        return types.is_vector(type(1)) && !types.is_matrix(type(0)) ? type(1) : type(0);
    case Op::select: return type(1);
    case Op::row_item:
    case Op::index: {
        const Type& whole = types[type(0)];
        return whole.kind == TypeKind::matrix ? vector(whole.element, whole.rows) : whole.element;
    }
    case Op::field: return program.structs[types[type(0)].struct_].fields[node.slot].type;
    case Op::call: return program.functions[node.function].result;
    case Op::some: return intern(Type{.kind = TypeKind::optional, .element = type(0)});
    case Op::has_value: return types.bool_;
    case Op::value: return types[type(0)].element;
    case Op::guarded_load:
    case Op::load:
    case Op::row_load:
    case Op::image_load:
    case Op::image_sample: return pass->bindings[node.slot].element;
    case Op::image_gather: return vector(pass->bindings[node.slot].element, 4);
    case Op::image_compare: return types.float_;
    case Op::intrinsic: {
        const std::string_view signature = signature_of(node.intrinsic);
        const std::size_t colon = signature.find(':');
        const char result = signature[colon + 1], first = signature[signature[0] == '@' ? 1 : 0];
        switch (result) {
        case 'b': return types.bool_;
        case 'u': return types.uint;
        case 'v': return types.void_;
        case 'w': return vector(types.uint, 4);
        case '=': return types.scalar_of(type(0));
        case 'B': return shaped(type(0), types.bool_);
        case 'S': return shaped(type(0), types.int_);
        case 'U': return shaped(type(0), types.uint);
        case 'L': return shaped(type(0), types.uint64);
        case 'D': return shaped(type(0), types.double_);
        case '2': return vector(types.float_, 2);
        case '4': return vector(types.float_, 4);
        default: break;
        }
        if (result == 'F' && (first == 'U' || first == 'S')) return shaped(type(0), types.float_);
        return node.operands.empty() ? types.error : type(0);
    }
    default: return types.error;
    }
}

}  // namespace gliftc::ir
