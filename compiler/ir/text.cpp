// Prints values and types in the language's syntax, and makes expressions of values.
#include "ir/evaluate.h"

#include <charconv>
#include <cmath>

namespace gliftc::ir {

namespace {

std::string number_text(double number, bool is_float) {
    char buffer[40];
    auto end = is_float ? std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(number)).ptr
                        : std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
    std::string text(buffer, end);
    if (text.find_first_of(".einf") == std::string::npos) text += ".0";
    return text;
}

std::string lane_text(const Types& types, TypeId scalar, const Lane& lane) {
    if (types.kind(scalar) == TypeKind::bool_) return lane.bits ? "true" : "false";
    if (types.is_floating(scalar)) return number_text(lane.number, types.kind(scalar) != TypeKind::double_);
    if (types.is_signed(scalar)) return std::to_string(static_cast<std::int64_t>(lane.bits));
    return std::to_string(lane.bits);
}

/// The value of the type whose lanes begin at `lanes`, which is moved behind them.
std::string value_text(const Program& program, TypeId id, const Lane*& lanes) {
    const Types& types = program.types;
    const Type& type = types[id];
    std::string parts;
    const auto add = [&](TypeId part) { parts += (parts.empty() ? "" : ", ") + value_text(program, part, lanes); };
    switch (type.kind) {
    case TypeKind::vector:
    case TypeKind::matrix:
        for (std::size_t i = lane_count(program, id); i > 0; --i) add(types.scalar_of(id));
        break;
    case TypeKind::array:
        for (std::uint32_t i = 0; i < type.count; ++i) add(type.element);
        break;
    case TypeKind::struct_:
        for (const StructField& field : program.structs[type.struct_].fields) add(field.type);
        break;
    case TypeKind::optional: {
        const bool has = (lanes++)->bits != 0;
        const std::string held = value_text(program, type.element, lanes);
        return has ? held : "none";
    }
    case TypeKind::enum_: {
        const Enum& of = program.enums[type.enum_];
        const std::uint64_t bits = (lanes++)->bits;
        for (std::size_t i = 0; i < of.values.size(); ++i)
            if (of.values[i] == bits) return (*program.names)[of.enumerators[i]];
        return std::to_string(bits);
    }
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: break;  // values of these have no lanes
    default: return lane_text(types, id, *lanes++);
    }
    return to_text(program, id) + "(" + parts + ")";
}

ExprId materialize_part(Program& program, TypeId type, const Lane*& lanes, Span span) {
    Types& types = program.types;
    Expr expr{.op = Op::construct, .type = type, .span = span};
    switch (types.kind(type)) {
    case TypeKind::vector:
        for (std::uint32_t i = 0; i < types[type].count; ++i)
            expr.operands.push_back(materialize_part(program, types[type].element, lanes, span));
        break;
    case TypeKind::matrix:
        for (std::uint32_t i = 0; i < types[type].count; ++i)
            expr.operands.push_back(
                materialize_part(program, types.vector(types[type].element, types[type].rows), lanes, span));
        break;
    case TypeKind::array:
        for (std::uint32_t i = 0; i < types[type].count; ++i)
            expr.operands.push_back(materialize_part(program, types[type].element, lanes, span));
        break;
    case TypeKind::struct_: {
        std::vector<TypeId> fields;
        for (const StructField& field : program.structs[types[type].struct_].fields) fields.push_back(field.type);
        for (TypeId field : fields) expr.operands.push_back(materialize_part(program, field, lanes, span));
        break;
    }
    case TypeKind::optional: {
        bool has = (lanes++)->bits != 0;
        ExprId value = materialize_part(program, types[type].element, lanes, span);
        expr.op = has ? Op::some : Op::none;
        if (has) expr.operands.push_back(value);
        break;
    }
    default:
        expr.op = Op::constant;
        expr.bits = lanes->bits;
        expr.number = lanes->number;
        ++lanes;
    }
    return program.exprs.add(std::move(expr));
}

}  // namespace

ExprId zero(Program& program, TypeId type, Span span) {
    Value value{type, {}};
    for (std::size_t i = lane_count(program, type); i > 0; --i) value.lanes.push_back({});
    return materialize(program, value, span);
}

ExprId materialize(Program& program, const Value& value, Span span) {
    const Lane* lanes = value.lanes.data();
    return materialize_part(program, value.type, lanes, span);
}

std::string to_text(const Program& program, const Value& value) {
    const Lane* lanes = value.lanes.data();
    return value_text(program, value.type, lanes);
}

std::string module_text(const Program& program, ModuleId module) {
    return (*program.names)[program.modules[module].name] + ".";
}

std::string to_qualified_text(const Program& program, TypeId id) {
    const Type& type = program.types[id];
    switch (type.kind) {
    case TypeKind::struct_: return program.structs[type.struct_].key;
    case TypeKind::structure: return program.structures[type.structure].key;
    case TypeKind::enum_: return module_text(program, program.enums[type.enum_].module) + to_text(program, id);
    case TypeKind::array: return to_qualified_text(program, type.element) + "[" + std::to_string(type.count) + "]";
    case TypeKind::optional: return to_qualified_text(program, type.element) + "?";
    case TypeKind::slice: return "slice of " + to_qualified_text(program, type.element);
    case TypeKind::device: return to_qualified_text(program, type.element) + " on the device";
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::bool_:
    case TypeKind::int_:
    case TypeKind::uint:
    case TypeKind::float_:
    case TypeKind::half:
    case TypeKind::double_:
    case TypeKind::int64:
    case TypeKind::uint64:
    case TypeKind::vector:
    case TypeKind::matrix: return to_text(program, id);
    }
    return "?";
}

std::string to_text(const Program& program, TypeId id) {
    const Type& type = program.types[id];
    switch (type.kind) {
    case TypeKind::error: return "?";
    case TypeKind::void_: return "nothing";
    case TypeKind::bool_: return "bool";
    case TypeKind::int_: return "int";
    case TypeKind::uint: return "uint";
    case TypeKind::float_: return "float";
    case TypeKind::half: return "half";
    case TypeKind::double_: return "double";
    case TypeKind::int64: return "int64";
    case TypeKind::uint64: return "uint64";
    case TypeKind::vector:
        if (type.element == program.types.int64 || type.element == program.types.uint64)
            return "vec<" + std::to_string(type.count) + ", " + to_text(program, type.element) + ">";
        return to_text(program, type.element) + std::to_string(type.count);
    case TypeKind::matrix:
        return to_text(program, type.element) + std::to_string(type.count) + "x" + std::to_string(type.rows);
    case TypeKind::array: return to_text(program, type.element) + "[" + std::to_string(type.count) + "]";
    case TypeKind::struct_: return program.structs[type.struct_].display;
    case TypeKind::enum_: return (*program.names)[program.enums[type.enum_].name];
    case TypeKind::optional: return to_text(program, type.element) + "?";
    case TypeKind::structure: return program.structures[type.structure].display;
    case TypeKind::slice: return "slice of " + to_text(program, type.element);
    case TypeKind::device: return to_text(program, type.element) + " on the device";
    }
    return "?";
}

}  // namespace gliftc::ir
