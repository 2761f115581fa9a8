// Values in blocks of GLSL (buffers, parameters). There glslang gives structs and arrays types of their own, with bools
// as uints; it converts between these and the types of variables where a whole is assigned, except arrays of bools.
#include "emit/glsl/printer.h"

#include <algorithm>
#include <functional>

namespace gliftc::glsl {

using ir::Op;
using ir::TypeId;
using ir::TypeKind;

namespace {

using PartOf = std::function<void(const std::string& selector, TypeId type)>;

/// Visits the parts of a struct, an array or an optional that have a non-empty type (ir/empty.h), each with the text
/// that selects it when appended to the whole (`.field`, `[2]`).
void for_each_part(const Printer& p, TypeId id, const PartOf& visit) {
    const ir::Type type = p.program.types[id];
    if (type.kind == TypeKind::struct_) {
        const auto& fields = p.program.structs[type.struct_].fields;
        for (std::size_t i = 0; i < fields.size(); ++i)
            if (!is_empty(p.program, fields[i].type)) visit("." + p.field_names[type.struct_][i], fields[i].type);
    } else if (type.kind == TypeKind::array) {
        for (std::uint32_t i = 0; i < type.count; ++i) visit("[" + std::to_string(i) + "]", type.element);
    } else if (type.kind == TypeKind::optional) {
        visit(".has", p.program.types.bool_);
        if (!is_empty(p.program, type.element)) visit(".value", type.element);
    }
}

void print_parts(Printer& p, const std::string& place, const std::string& value, TypeId id) {
    if (!may_hold_bool_array(p.program, id)) return line(p, place + " = " + value + ";");
    for_each_part(p, id, [&](const std::string& selector, TypeId part) {
        print_parts(p, place + selector, value + selector, part);
    });
}

}  // namespace

bool lies_in_block(const ir::Program& program, ir::ExprId id) {
    const ir::Expr& expr = program.exprs[id];
    if (expr.op == Op::parameter || expr.op == Op::load) return true;
    const bool part = expr.op == Op::field || expr.op == Op::index || expr.op == Op::value;
    return part && lies_in_block(program, expr.operands[0]);
}

bool holds_bool(const ir::Program& program, TypeId id) {
    const ir::Type& type = program.types[id];
    if (type.kind == TypeKind::array || type.kind == TypeKind::optional) return holds_bool(program, type.element);
    if (type.kind != TypeKind::struct_) return program.types.scalar_of(id) == program.types.bool_;
    return std::ranges::any_of(program.structs[type.struct_].fields,
                               [&](const ir::StructField& field) { return holds_bool(program, field.type); });
}

bool holds_bool_array(const ir::Program& program, TypeId id) {
    const ir::Type& type = program.types[id];
    if (type.kind == TypeKind::array) {
        TypeId element = type.element;
        while (program.types.kind(element) == TypeKind::array) element = program.types[element].element;
        return program.types.scalar_of(element) == program.types.bool_ || may_hold_bool_array(program, element);
    }
    if (type.kind != TypeKind::struct_) return false;
    return std::ranges::any_of(program.structs[type.struct_].fields,
                               [&](const ir::StructField& field) { return may_hold_bool_array(program, field.type); });
}

std::string remade(Printer& p, const std::string& place, TypeId id) {
    std::string parts;
    for_each_part(p, id, [&](const std::string& selector, TypeId part) {
        parts += (parts.empty() ? "" : ", ") + remade(p, place + selector, part);
    });
    return parts.empty() ? place : type_text(p, id) + "(" + parts + padding_values(p, id) + ")";
}

void print_store(Printer& p, const std::string& place, const std::string& value, TypeId type) {
    if (!may_hold_bool_array(p.program, type)) return line(p, place + " = " + value + ";");
    line(p, "{");
    p.names.enter();
    ++p.indent;
    const std::string stored = p.names.declare("stored");
    line(p, declaration(p, type, stored) + " = " + value + ";");
    print_parts(p, place, stored, type);
    --p.indent;
    p.names.leave();
    line(p, "}");
}

}  // namespace gliftc::glsl
