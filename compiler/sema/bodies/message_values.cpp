#include "sema/bodies/message_values.h"

#include "sema/bodies/builder.h"

namespace gliftc::sema {

namespace {

using ir::TypeKind;

/// The texts of `count` parts, each `part`, as a list in braces.
std::optional<std::string> list_of(const std::optional<std::string>& part, std::uint32_t count) {
    if (!part) return std::nullopt;
    std::string text = "{{";
    for (std::uint32_t i = 0; i < count; ++i) text += (i ? ", " : "") + *part;
    return text + "}}";
}

/// The members of a value that is made of several: components, columns, elements or fields.
std::vector<ir::ExprId> parts_of(ir::Program& p, ir::ExprId whole) {
    const Span span = p.exprs[whole].span;
    const ir::Type type = p.types[p.exprs[whole].type];
    std::vector<ir::ExprId> parts;
    switch (type.kind) {
    case TypeKind::vector:
        for (std::uint32_t i = 0; i < type.count; ++i)
            parts.push_back(make_swizzle(p, whole, static_cast<std::uint8_t>(i), span));
        return parts;
    case TypeKind::matrix:
    case TypeKind::array: {
        const ir::TypeId part = type.kind == TypeKind::matrix ? p.types.vector(type.element, type.rows) : type.element;
        for (std::uint32_t i = 0; i < type.count; ++i)
            parts.push_back(add(p, ir::Op::index, part, span, {whole, make_uint(p, i, span)}));
        return parts;
    }
    case TypeKind::struct_:
        for (std::uint32_t i = 0; i < p.structs[type.struct_].fields.size(); ++i) {
            parts.push_back(add(p, ir::Op::field, p.structs[type.struct_].fields[i].type, span, {whole}));
            p.exprs[parts.back()].slot = i;
        }
        return parts;
    default: return parts;
    }
}

ir::ExprId bits_of(ir::Program& p, ir::Intrinsic cast, ir::TypeId to, ir::ExprId value) {
    const ir::ExprId bits = add(p, ir::Op::intrinsic, to, p.exprs[value].span, {value});
    p.exprs[bits].intrinsic = cast;
    return bits;
}

/// The lower word, then the upper one.
void add_two_words(ir::Program& p, ir::ExprId value, ir::Operands& words) {
    const Span span = p.exprs[value].span;
    const ir::TypeId type = p.types.uint64;
    const auto constant = [&](std::uint64_t bits) {
        const ir::ExprId id = add(p, ir::Op::constant, type, span);
        p.exprs[id].bits = bits;
        return id;
    };
    const ir::ExprId low = make_binary(p, ir::BinaryOp::bit_and, type, value, constant(0xffffffffu), span);
    const ir::ExprId high = make_binary(p, ir::BinaryOp::shift_right, type, value, constant(32), span);
    words.push_back(add(p, ir::Op::convert, p.types.uint, span, {low}));
    words.push_back(add(p, ir::Op::convert, p.types.uint, span, {high}));
}

}  // namespace

std::optional<std::string> message_text(const ir::Program& p, ir::TypeId id) {
    const ir::Type& type = p.types[id];
    switch (type.kind) {
    case TypeKind::bool_: return "{b}";
    case TypeKind::int_: return "{i}";
    case TypeKind::uint: return "{u}";
    case TypeKind::float_: return "{f}";
    case TypeKind::half: return "{h}";
    case TypeKind::double_: return "{d}";
    case TypeKind::int64: return "{I}";
    case TypeKind::uint64: return "{U}";
    case TypeKind::enum_: {
        const ir::Enum& values = p.enums[type.enum_];
        std::string text = "{e";
        for (std::size_t i = 0; i < values.enumerators.size(); ++i)
            text += " " + std::to_string(values.values[i]) + "=" + (*p.names)[values.enumerators[i]];
        return text + "}";
    }
    case TypeKind::vector:
    case TypeKind::array: return list_of(message_text(p, type.element), type.count);
    case TypeKind::matrix: return list_of(list_of(message_text(p, type.element), type.rows), type.count);
    case TypeKind::struct_: {
        std::string text = "{{", between;
        for (const ir::StructField& field : p.structs[type.struct_].fields) {
            const std::optional<std::string> part = message_text(p, field.type);
            if (!part) return std::nullopt;
            text += std::exchange(between, ", ") + (*p.names)[field.name] + ": " + *part;
        }
        return text + "}}";
    }
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::optional:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: return std::nullopt;
    }
    return std::nullopt;
}

std::uint64_t message_words(const ir::Program& p, ir::TypeId id) {
    const ir::Type& type = p.types[id];
    switch (type.kind) {
    case TypeKind::vector:
    case TypeKind::array: return type.count * message_words(p, type.element);
    case TypeKind::matrix: return std::uint64_t{type.count} * type.rows * message_words(p, type.element);
    case TypeKind::struct_: {
        std::uint64_t words = 0;
        for (const ir::StructField& field : p.structs[type.struct_].fields) words += message_words(p, field.type);
        return words;
    }
    case TypeKind::double_:
    case TypeKind::int64:
    case TypeKind::uint64: return 2;
    default: return 1;
    }
}

void add_words(ir::Program& p, ir::ExprId value, ir::Operands& words) {
    const Span span = p.exprs[value].span;
    switch (p.types.kind(p.exprs[value].type)) {
    case TypeKind::bool_:
        return words.push_back(
            add(p, ir::Op::select, p.types.uint, span, {value, make_uint(p, 1, span), make_uint(p, 0, span)}));
    case TypeKind::uint: return words.push_back(value);
    case TypeKind::int_:
    case TypeKind::enum_: return words.push_back(add(p, ir::Op::convert, p.types.uint, span, {value}));
    case TypeKind::half: return add_words(p, add(p, ir::Op::convert, p.types.float_, span, {value}), words);
    case TypeKind::float_: return words.push_back(bits_of(p, ir::Intrinsic::floatBitsToUint, p.types.uint, value));
    case TypeKind::double_:
        return add_two_words(p, bits_of(p, ir::Intrinsic::doubleBitsToUint64, p.types.uint64, value), words);
    case TypeKind::int64: return add_two_words(p, add(p, ir::Op::convert, p.types.uint64, span, {value}), words);
    case TypeKind::uint64: return add_two_words(p, value, words);
    default:
        for (const ir::ExprId part : parts_of(p, value)) add_words(p, part, words);
    }
}

}  // namespace gliftc::sema
