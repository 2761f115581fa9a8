#include "sema/bodies/closures.h"
#include "sema/bodies/order.h"

#include "sema/names/record.h"
#include "sema/names/unknown_names.h"
#include "sema/pipelines/predication.h"
#include "sema/pipelines/values.h"
#include "sema/types/instances.h"
#include "sema/types/typing.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace gliftc::sema {

namespace {

/// The type of an unsuffixed literal in a context that expects `wanted`.
ir::TypeId literal_type(Body& body, const ast::Expr& literal, ir::TypeId wanted) {
    ir::Types& types = body.types();
    bool floating = literal.kind == ast::ExprKind::float_literal;
    wanted = operand_hint(types, wanted);
    if (wanted) wanted = types.scalar_of(wanted);
    if (wanted && types.is_number(wanted) && (!floating || types.is_floating(wanted))) return wanted;
    return floating ? types.float_ : types.int_;
}

ir::TypeId suffix_type(ir::Types& types, std::string_view suffix) {
    if (suffix == "u") return types.uint;
    if (suffix == "l") return types.int64;
    if (suffix == "ul") return types.uint64;
    if (suffix == "f") return types.float_;
    if (suffix == "h") return types.half;
    if (suffix == "d") return types.double_;
    return {};
}

bool fits(const ir::Types& types, ir::TypeId type, std::uint64_t value, bool negative) {
    switch (types.kind(type)) {
    case ir::TypeKind::int_: return value <= 0x7fffffffu + (negative ? 1u : 0u);
    case ir::TypeKind::uint: return value <= 0xffffffffu;
    case ir::TypeKind::int64: return value <= 0x7fffffffffffffffu + (negative ? 1u : 0u);
    default: return true;
    }
}

std::string shortest(double number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

ir::ExprId number_literal(Body& body, const ast::Expr& literal, ir::TypeId wanted, bool negative) {
    ir::Types& types = body.types();
    ir::TypeId type = suffix_type(types, literal.suffix);
    if (!type) type = literal_type(body, literal, wanted);
    bool is_integer = literal.kind == ast::ExprKind::int_literal;
    if (is_integer && !fits(types, type, literal.value, negative))
        body.context.error(Diag::number_too_large, literal.span,
                           {std::to_string(literal.value), body.context.text(type)});
    ir::Lane lane;
    if (types.is_floating(type)) {
        double number = is_integer ? static_cast<double>(literal.value) : literal.number;
        lane.number = negative ? -number : number;
    } else {
        lane.bits = negative ? 0 - literal.value : literal.value;
    }
    const double exact = lane.number;
    lane = ir::normalize(types, type, lane);
    if (types.is_floating(type) && std::isfinite(exact) && !std::isfinite(lane.number))
        body.context.error(
            Diag::number_too_large, literal.span,
            {is_integer ? std::to_string(literal.value) : shortest(literal.number), body.context.text(type)});
    ir::ExprId id = add(body.program(), ir::Op::constant, type, literal.span);
    body.program().exprs[id].bits = lane.bits;
    body.program().exprs[id].number = lane.number;
    return id;
}

Operand symbol_operand(Body& body, Symbol& symbol, const ast::Expr& name) {
    ir::Program& program = body.program();
    symbol.used = true;
    Operand operand;
    operand.span = name.span;
    switch (symbol.kind) {
    case SymbolKind::local: {
        if (body.types().kind(symbol.type) == ir::TypeKind::structure ||
            body.types().kind(symbol.type) == ir::TypeKind::slice) {
            operand.kind = OperandKind::structure;
            operand.local = symbol.local;
            operand.is_slice = body.types().kind(symbol.type) == ir::TypeKind::slice;
            const ir::Type& type = body.types()[symbol.type];
            operand.structure = operand.is_slice ? body.types()[type.element].structure : type.structure;
            operand.type = symbol.type;
            return operand;
        }
        const ir::ExprId local = make_local(program, symbol.local, name.span);
        if (is_changeable(body, local)) add_read(body, local);
        return value_operand(body, local, name.span);
    }
    case SymbolKind::structure:
    case SymbolKind::memory:
        operand.kind = symbol.kind == SymbolKind::structure ? OperandKind::structure : OperandKind::memory;
        operand.place = symbol.place;
        operand.structure = symbol.structure;
        operand.slot = symbol.slot;
        operand.window = symbol.window;
        operand.writing = symbol.writing;
        operand.local = symbol.local;
        return operand;
    case SymbolKind::state:
    case SymbolKind::member:
    case SymbolKind::host_state: {
        ir::Op op = symbol.kind == SymbolKind::state    ? ir::Op::state
                    : symbol.kind == SymbolKind::member ? ir::Op::member
                                                        : ir::Op::host_state;
        ir::ExprId id = add(program, op, symbol.type, name.span);
        program.exprs[id].slot = symbol.slot;
        program.exprs[id].place = symbol.place;
        if (op == ir::Op::host_state) add_read(body, id);
        return value_operand(body, id, name.span);
    }
    case SymbolKind::iterator:
        operand.kind = OperandKind::iterator;
        operand.slot = symbol.slot;
        operand.structure = symbol.structure;
        operand.place = symbol.place;
        return operand;
    }
    return error_operand(name.span);
}

Operand check_name(Body& body, ast::ExprId id) {
    Context& c = body.context;
    const ast::Expr& expr = c[id];
    if (Symbol* symbol = find_symbol(body, expr.name)) {
        record_use(c, expr.span, symbol->span);
        return symbol_operand(body, *symbol, expr);
    }
    Meta meta = find_meta(c, body.env, {expr.name, expr.span});
    if (meta.kind == MetaKind::value)
        return value_operand(body, ir::materialize(body.program(), meta.value, expr.span), expr.span);
    if (meta.kind == MetaKind::running) {
        c.error(Diag::not_constant, expr.span);
        return error_operand(expr.span);
    }
    if (is_constant(c, meta)) return constant_operand(body, meta, expr.span);
    if (meta.kind != MetaKind::none) {
        Operand operand;
        operand.kind = OperandKind::meta;
        operand.span = expr.span;
        operand.meta = std::move(meta);
        return operand;
    }
    if (find_intrinsic(c.text(expr.name))) {
        c.error(Diag::not_a_value, expr.span, {"the function '" + c.text(expr.name) + "'"});
        return error_operand(expr.span);
    }
    std::vector<std::string_view> visible;
    for (const auto& scope : body.scopes)
        for (const auto& [name, symbol] : scope) visible.push_back(c.text(name));
    report_unknown(c, body.env, {expr.name, expr.span}, visible);
    return error_operand(expr.span);
}

/// `{ a, b }` as a value of the wanted type, such as an array, struct or vector; where `T?` is wanted, of type T.
Operand check_tuple(Body& body, const ast::Expr& expr, ir::TypeId wanted) {
    if (wanted && body.types().kind(wanted) == ir::TypeKind::optional) wanted = body.types()[wanted].element;
    if (!wanted || wanted == body.types().error) {
        body.context.error(Diag::tuple_type, expr.span);
        return error_operand(expr.span);
    }
    return construct_value(body, wanted, expr);
}

Operand check_await(Body& body, const ast::Expr& expr) {
    Context& c = body.context;
    if (body.kind != BodyKind::pipeline) {
        c.error(Diag::await_outside_pipeline, expr.span);
        return error_operand(expr.span);
    }
    if (is_refused_in_arm(body, "'await'", expr.span, "use the value on the device, or wait before the condition"))
        return error_operand(expr.span);
    needs_host(body, expr.span);
    Operand operand = check(body, expr.operands[0]);
    ir::ExprId value = to_value(body, operand);
    if (is_error(body, value)) return error_operand(expr.span);
    ir::Expr& node = body.program().exprs[value];
    if (body.types().kind(node.type) != ir::TypeKind::device) {
        note(c.error(Diag::await_host_value, expr.span), expr.span,
             "this value is known to the host already: leave out 'await'");
        return error_operand(expr.span);
    }
    ir::TypeId type = body.types()[node.type].element;
    if (node.op == ir::Op::device_read) {
        node.op = ir::Op::host_read;
        node.type = type;
        return value_operand(body, value, expr.span);
    }
    const ir::ExprId awaited = add(body.program(), ir::Op::await_value, type, expr.span, {value});
    add_read(body, awaited);
    return value_operand(body, awaited, expr.span);
}

Operand check_kind(Body& body, ast::ExprId id, ir::TypeId wanted) {
    Context& c = body.context;
    const ast::Expr& expr = c[id];
    switch (expr.kind) {
    case ast::ExprKind::error: return error_operand(expr.span);
    case ast::ExprKind::int_literal:
    case ast::ExprKind::float_literal: return value_operand(body, number_literal(body, expr, wanted, false), expr.span);
    case ast::ExprKind::bool_literal:
        return value_operand(body, make_bool(body.program(), expr.value != 0, expr.span), expr.span);
    case ast::ExprKind::string_literal:
        c.error(Diag::not_a_value, expr.span, {"a string"});
        return error_operand(expr.span);
    case ast::ExprKind::none_literal:
        if (!wanted || body.types().kind(wanted) != ir::TypeKind::optional) {
            if (wanted != body.types().error) c.error(Diag::none_type, expr.span);
            return error_operand(expr.span);
        }
        return value_operand(body, add(body.program(), ir::Op::none, wanted, expr.span), expr.span);
    case ast::ExprKind::name: return check_name(body, id);
    case ast::ExprKind::generic:
    case ast::ExprKind::optional: {
        Operand operand;
        operand.meta = meta_of(c, env_for(body, id), id);
        operand.kind = operand.meta.kind == MetaKind::none ? OperandKind::error : OperandKind::meta;
        operand.span = expr.span;
        return operand;
    }
    case ast::ExprKind::named:
        c.error(Diag::named_argument, expr.name_span, {c.text(expr.name)});
        return error_operand(expr.span);
    case ast::ExprKind::member: return check_member(body, id);
    case ast::ExprKind::index: return check_index(body, id, wanted);
    case ast::ExprKind::call: return check_call(body, id, wanted);
    case ast::ExprKind::unary: return check_unary(body, id, wanted);
    case ast::ExprKind::binary: return check_binary(body, id, wanted);
    case ast::ExprKind::conditional: return check_conditional(body, expr, wanted);
    case ast::ExprKind::range: c.error(Diag::not_a_value, expr.span, {"a range"}); return error_operand(expr.span);
    case ast::ExprKind::await: return check_await(body, expr);
    case ast::ExprKind::tuple: return check_tuple(body, expr, wanted);
    case ast::ExprKind::closure: return check_closure(body, id);
    case ast::ExprKind::known_type: break;
    }
    return error_operand(expr.span);
}

std::string describe(const Body& body, const Operand& operand) {
    const Context& c = body.context;
    switch (operand.kind) {
    case OperandKind::structure: return "the structure " + c.program.structures[operand.structure].display;
    case OperandKind::iterator: return "the iterator '" + c.text(body.kernel->params[operand.slot].name) + "'";
    case OperandKind::meta:
        if (operand.meta.kind == MetaKind::type) return "the type " + c.text(operand.meta.type);
        if (operand.meta.kind == MetaKind::declarations)
            return "'" + c.text(c[operand.meta.declarations[0]].name.name) + "'";
        return "this";
    default: return "this";
    }
}

/// Reports the use of a buffer or an image, which only its structure's translator addresses, as a value.
void report_memory(Body& body, const Operand& operand) {
    Context& c = body.context;
    const ir::Memory& memory = c.program.structures[operand.structure].memories[operand.slot];
    const std::string name = c.text(memory.name);
    const bool is_buffer = memory.shape == ir::MemoryShape::buffer;
    note(c.error(Diag::not_a_value, operand.span, {(is_buffer ? "the buffer '" : "the image '") + name + "'"}),
         operand.span,
         "elements are accessed by addresses of the structure that has it, 's[a]'; to pass it by itself, make it a "
         "structure, as in 'memory " +
             name + " = " + (is_buffer ? "Array<1, " + c.text(memory.element) + ">(n)'" : "Image<r32f>(extent)'"));
}

}  // namespace

bool is_constant(const Context& c, const Meta& meta) {
    return meta.kind == MetaKind::declarations && meta.declarations.size() == 1 &&
           std::holds_alternative<ast::Const>(c[meta.declarations[0]].body);
}

Operand constant_operand(Body& body, const Meta& constant, Span span) {
    const ir::ExprId value = constant_declaration(body.context, constant.declarations[0]);
    const auto known = value ? ir::evaluate(body.program(), value) : std::nullopt;
    return known ? value_operand(body, ir::materialize(body.program(), *known, span), span) : error_operand(span);
}

Operand error_operand(Span span) {
    Operand operand;
    operand.span = span;
    return operand;
}

ir::ExprId error_value(Body& body, Span span) {
    return add(body.program(), ir::Op::constant, body.types().error, span);
}

bool is_error(const Body& body, ir::ExprId id) {
    return !id || body.context.program.exprs[id].type == body.context.program.types.error;
}

Operand value_operand(Body& body, ir::ExprId expr, Span span) {
    Operand operand;
    operand.kind = is_error(body, expr) ? OperandKind::error : OperandKind::value;
    operand.span = span;
    operand.expr = expr;
    operand.type = body.program().exprs[expr].type;
    return operand;
}

Operand check(Body& body, ast::ExprId id, ir::TypeId wanted) {
    if (!id) return error_operand({});
    const bool is_part = std::exchange(body.is_open, false);
    Operand operand = check_kind(body, id, wanted);
    body.is_open = is_part;
    record_operand(body, body.context[id], operand);
    if (body.kind != BodyKind::pipeline) return operand;
    return is_part ? opened(body, std::move(operand)) : closed(body, std::move(operand));
}

ir::ExprId to_value(Body& body, const Operand& operand) {
    switch (operand.kind) {
    case OperandKind::value: return operand.expr;
    case OperandKind::error: return error_value(body, operand.span);
    case OperandKind::iterator: {
        Operand value = iterator_value(body, operand);
        return value.kind == OperandKind::value ? value.expr : error_value(body, operand.span);
    }
    case OperandKind::structure:
        if (body.kind == BodyKind::pipeline || body.kind == BodyKind::structure) {
            if (operand.is_slice && operand.place.members.empty())
                return make_local(body.program(), operand.local, operand.span);
            ir::TypeId type = body.types().of_structure(operand.structure);
            return structure_operation(body, ir::Op::structure_value, type, operand, operand.span);
        }
        body.context.error(Diag::not_a_value, operand.span, {describe(body, operand)});
        break;
    case OperandKind::memory: report_memory(body, operand); break;
    case OperandKind::meta: body.context.error(Diag::not_a_value, operand.span, {describe(body, operand)}); break;
    }
    return error_value(body, operand.span);
}

ir::ExprId coerce(Body& body, ir::ExprId expr, ir::TypeId wanted, Span span) {
    ir::Types& types = body.types();
    ir::TypeId have = body.program().exprs[expr].type;
    if (!wanted || have == wanted || have == types.error || wanted == types.error) return expr;
    if (becomes(types, have, wanted)) {
        const ir::ExprId value = coerce(body, expr, types[wanted].element, span);
        return add(body.program(), ir::Op::some, wanted, span, {value});
    }
    if (report_closure(body.context, have, wanted, span)) return error_value(body, span);
    Diagnostic& diagnostic =
        body.context.error(Diag::type_mismatch, span, {body.context.text(wanted), body.context.text(have)});
    if (types.kind(have) == ir::TypeKind::device && types[have].element == wanted)
        note(diagnostic, span, "the value lives on the device: 'await' brings it to the host");
    else if (wanted == types.bool_ && types.is_number(have))
        note(diagnostic, span, "a number is no condition: write 'x != 0'");
    else if (types.is_number(types.scalar_of(have)) && types.is_number(types.scalar_of(wanted)) &&
             types.components(have) == types.components(wanted))
        note(diagnostic, span, "there are no implicit conversions: write " + body.context.text(wanted) + "(…)");
    note_optional(body, diagnostic, span, have);
    return error_value(body, span);
}

void note_optional(Body& body, Diagnostic& diagnostic, Span span, ir::TypeId found) {
    if (body.types().kind(found) == ir::TypeKind::optional)
        note(diagnostic, span,
             "it may have no value: 'x ?? other' gives another one then, 'if let v = x { … }' runs only where there is "
             "one");
}

ir::ExprId check_hinted(Body& body, ast::ExprId id, ir::TypeId hint) { return to_value(body, check(body, id, hint)); }

ir::ExprId check_value(Body& body, ast::ExprId id, ir::TypeId wanted) {
    ir::ExprId value = check_hinted(body, id, wanted);
    return wanted ? coerce(body, value, wanted, body.context[id].span) : value;
}

Operand check_unary(Body& body, ast::ExprId id, ir::TypeId wanted) {
    Context& c = body.context;
    const ast::Expr& expr = c[id];
    const ast::Expr& inner = c[expr.operands[0]];
    const Parts parts(body);
    bool literal = inner.kind == ast::ExprKind::int_literal || inner.kind == ast::ExprKind::float_literal;
    if (expr.unary == ast::UnaryOp::minus && literal) {
        ir::ExprId value = number_literal(body, inner, wanted, true);
        if (!body.types().is_floating(body.program().exprs[value].type) &&
            !body.types().is_signed(body.program().exprs[value].type) && inner.value != 0) {
            note(c.error(Diag::negative_unsigned, expr.span, {c.text(body.program().exprs[value].type)}), expr.span,
                 "it is a whole number from 0 on: subtract, or convert a negative number, as in " +
                     c.text(body.program().exprs[value].type) + "(int(…))");
            return error_operand(expr.span);
        }
        return value_operand(body, value, expr.span);
    }
    ir::TypeId hint = operand_hint(body.types(), wanted);
    if (expr.unary == ast::UnaryOp::bit_not && hint && body.types().is_floating(body.types().scalar_of(hint)))
        hint = {};
    ir::ExprId value = expr.unary == ast::UnaryOp::logical_not ? check_value(body, expr.operands[0], body.types().bool_)
                                                               : check_hinted(body, expr.operands[0], hint);
    if (is_error(body, value)) return error_operand(expr.span);
    ir::TypeId type = body.program().exprs[value].type, scalar = body.types().scalar_of(type);
    bool right = expr.unary == ast::UnaryOp::logical_not ? type == body.types().bool_
                 : expr.unary == ast::UnaryOp::bit_not   ? body.types().is_integer(scalar)
                                                         : body.types().is_number(scalar);
    if (!right) {
        const char* sign = expr.unary == ast::UnaryOp::logical_not ? "!"
                           : expr.unary == ast::UnaryOp::bit_not   ? "~"
                           : expr.unary == ast::UnaryOp::plus      ? "+"
                                                                   : "-";
        note_optional(body, c.error(Diag::unary_operand, expr.span, {sign, c.text(type)}), expr.span, type);
        return error_operand(expr.span);
    }
    if (expr.unary == ast::UnaryOp::plus) return value_operand(body, value, expr.span);
    ir::ExprId result = add(body.program(), ir::Op::unary, type, expr.span, {value});
    body.program().exprs[result].unary = expr.unary == ast::UnaryOp::minus         ? ir::UnaryOp::minus
                                         : expr.unary == ast::UnaryOp::logical_not ? ir::UnaryOp::logical_not
                                                                                   : ir::UnaryOp::bit_not;
    return value_operand(body, result, expr.span);
}

}  // namespace gliftc::sema
