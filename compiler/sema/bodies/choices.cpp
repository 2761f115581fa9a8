// Choices between two values: `c ? a : b`, `select(c, a, b)`, `a ?? b`.
#include "sema/bodies/order.h"
#include "sema/pipelines/values.h"
#include "sema/types/typing.h"

#include <utility>

namespace gliftc::sema {

namespace {

/// The type hint for the second operand, once the first is checked.
ir::TypeId hint_for_second(Body& body, ast::ExprId second, ir::TypeId first, ir::TypeId wanted) {
    ir::Types& types = body.types();
    if (typing_of(body.context, second) != Typing::none) return first;
    const bool becomes_wanted = wanted && types.kind(wanted) == ir::TypeKind::optional && becomes(types, first, wanted);
    if (becomes_wanted) return wanted;
    return first == types.error || types.kind(first) == ir::TypeKind::optional ? first : types.optional(first);
}

/// Checks both operands and unifies their types: literals take the other operand's type, `none` takes the optional of
/// that type, a value beside an optional is wrapped, and a value that the host knows is computed on the device if the
/// other one lies there. `wanted` is the type hint for the operand that is checked first, and for a `none` beside it.
std::pair<Alternative, Alternative> check_sides(Body& body, ast::ExprId yes, ast::ExprId no, ir::TypeId wanted) {
    const Context& c = body.context;
    const bool is_swapped = typing_of(c, no) < typing_of(c, yes);
    const ast::ExprId first = is_swapped ? no : yes, second = is_swapped ? yes : no;
    Alternative a = recorded(body, [&] { return check_hinted(body, first, wanted); });
    const ir::TypeId hint = hint_for_second(body, second, body.program().exprs[a.value].type, wanted);
    Alternative b = recorded(body, [&] { return check_hinted(body, second, hint); });
    if (is_on_device(body, a.value) != is_on_device(body, b.value)) {
        Alternative& known = is_on_device(body, a.value) ? b : a;
        const Recording recording(body, known.steps);
        known.value = on_device(body, known.value);
    }
    const ir::TypeId type_a = body.program().exprs[a.value].type, type_b = body.program().exprs[b.value].type;
    if (becomes(body.types(), type_a, type_b)) a.value = coerce(body, a.value, type_b, c[first].span);
    else b.value = coerce(body, b.value, type_a, c[second].span);
    if (is_swapped) std::swap(a, b);
    return {std::move(a), std::move(b)};
}

Operand check_choice(Body& body, const std::vector<ast::ExprId>& parts, ir::TypeId wanted, Span span) {
    std::optional<Parts> operands(std::in_place, body);
    const ir::ExprId condition = check_value(body, parts[0], body.types().bool_);
    // If the host knows the condition, only the side that it chooses shall be computed: each side is then an expression
    // of its own, which has its own passes.
    if (!is_open(body, condition)) operands.reset();
    auto [yes, no] = check_sides(body, parts[1], parts[2], wanted);
    if (is_error(body, yes.value) || is_error(body, no.value)) return error_operand(span);
    return value_operand(body, choose_value(body, condition, std::move(yes), std::move(no), span), span);
}

}  // namespace

Operand check_conditional(Body& body, const ast::Expr& expr, ir::TypeId wanted) {
    return check_choice(body, {expr.operands[0], expr.operands[1], expr.operands[2]}, wanted, expr.span);
}

Operand call_select(Body& body, const ast::Expr& call, ir::TypeId wanted) {
    if (call.operands.size() != 4) {
        body.context.error(Diag::argument_count, call.span, {"select", "3", std::to_string(call.operands.size() - 1)});
        return error_operand(call.span);
    }
    return check_choice(body, {call.operands[1], call.operands[2], call.operands[3]}, wanted, call.span);
}

Operand check_otherwise(Body& body, const ast::Expr& expr, ir::TypeId wanted) {
    ir::Types& types = body.types();
    const Parts parts(body);
    const ir::TypeId value_hint = operand_hint(types, wanted);
    ir::ExprId optional = check_hinted(body, expr.operands[0], value_hint ? types.optional(value_hint) : ir::TypeId{});
    if (is_error(body, optional)) return error_operand(expr.span);
    const ir::TypeId type = body.program().exprs[optional].type;
    if (types.kind(type) != ir::TypeKind::optional) {
        body.context.error(Diag::not_optional, body.context[expr.operands[0]].span, {body.context.text(type)});
        return error_operand(expr.span);
    }
    if (is_open(body, optional)) settle(body);
    else if (body.block)
        optional = make_local(body.program(), emit_temporary(body, "found", optional, expr.span), expr.span);
    const ir::TypeId element = types[type].element;
    Alternative fallback = recorded(body, [&] { return check_value(body, expr.operands[1], element); });
    if (is_error(body, fallback.value)) return error_operand(expr.span);
    const ir::ExprId has = add(body.program(), ir::Op::has_value, types.bool_, expr.span, {optional});
    const ir::ExprId value = add(body.program(), ir::Op::value, element, expr.span, {optional});
    return value_operand(body, choose_value(body, has, {value, {}}, std::move(fallback), expr.span), expr.span);
}

}  // namespace gliftc::sema
