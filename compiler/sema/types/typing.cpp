#include "sema/types/typing.h"

#include "ir/empty.h"
#include "sema/types/meta.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

Typing typing_of_binary(const Context& c, const ast::Expr& expr) {
    const Typing left = typing_of(c, expr.operands[0]), right = typing_of(c, expr.operands[1]);
    switch (expr.binary) {
    case ast::BinaryOp::multiply:
    case ast::BinaryOp::divide:
    case ast::BinaryOp::remainder:
    case ast::BinaryOp::add:
    case ast::BinaryOp::subtract:
    case ast::BinaryOp::shift_left:
    case ast::BinaryOp::shift_right:
    case ast::BinaryOp::bit_and:
    case ast::BinaryOp::bit_xor:
    case ast::BinaryOp::bit_or:
    case ast::BinaryOp::otherwise: return std::min(left, right);
    case ast::BinaryOp::less:
    case ast::BinaryOp::less_equal:
    case ast::BinaryOp::greater:
    case ast::BinaryOp::greater_equal:
    case ast::BinaryOp::equal:
    case ast::BinaryOp::not_equal:
    case ast::BinaryOp::logical_and:
    case ast::BinaryOp::logical_or:
    case ast::BinaryOp::then: return Typing::own;
    }
    return Typing::own;
}

/// The common default type of two operands made of literals. An absent type is that of `none`, and makes the result an
/// optional.
ir::TypeId joined(ir::Types& types, ir::TypeId a, ir::TypeId b) {
    if (!a || !b) {
        const ir::TypeId type = a ? a : b;
        return !type || types.kind(type) == ir::TypeKind::optional ? type : types.optional(type);
    }
    if (types.kind(a) == ir::TypeKind::optional || types.kind(b) == ir::TypeKind::optional)
        return types.optional(joined(types, operand_hint(types, a), operand_hint(types, b)));
    return a == types.float_ ? a : b;
}

}  // namespace

Typing typing_of(const Context& c, ast::ExprId id) {
    const ast::Expr& expr = c[id];
    switch (expr.kind) {
    case ast::ExprKind::int_literal:
    case ast::ExprKind::float_literal: return expr.suffix[0] == 0 ? Typing::literal : Typing::own;
    case ast::ExprKind::none_literal: return Typing::none;
    case ast::ExprKind::unary:
        return expr.unary == ast::UnaryOp::logical_not ? Typing::own : typing_of(c, expr.operands[0]);
    case ast::ExprKind::binary: return typing_of_binary(c, expr);
    case ast::ExprKind::conditional: return std::min(typing_of(c, expr.operands[1]), typing_of(c, expr.operands[2]));
    default: return Typing::own;
    }
}

bool waits_for_parameter(const Context& c, ast::ExprId id) {
    return typing_of(c, id) != Typing::own || c[id].kind == ast::ExprKind::tuple;
}

ir::TypeId own_type(Context& c, ast::ExprId id) {
    const ast::Expr& expr = c[id];
    switch (expr.kind) {
    case ast::ExprKind::int_literal: return c.types().int_;
    case ast::ExprKind::float_literal: return c.types().float_;
    case ast::ExprKind::unary: return own_type(c, expr.operands[0]);
    case ast::ExprKind::conditional:
        return joined(c.types(), own_type(c, expr.operands[1]), own_type(c, expr.operands[2]));
    case ast::ExprKind::binary: {
        const ir::TypeId type = joined(c.types(), own_type(c, expr.operands[0]), own_type(c, expr.operands[1]));
        return expr.binary == ast::BinaryOp::otherwise ? operand_hint(c.types(), type) : type;
    }
    default: return {};
    }
}

ir::TypeId operand_hint(const ir::Types& types, ir::TypeId wanted) {
    while (wanted && (types.kind(wanted) == ir::TypeKind::optional || types.kind(wanted) == ir::TypeKind::device))
        wanted = types[wanted].element;
    return wanted;
}

bool holds_optional(const ir::Program& program, ir::TypeId id) {
    const ir::Type& type = program.types[id];
    if (type.kind == ir::TypeKind::optional) return true;
    if (type.kind == ir::TypeKind::array) return holds_optional(program, type.element);
    if (type.kind != ir::TypeKind::struct_) return false;
    const auto& fields = program.structs[type.struct_].fields;
    return std::ranges::any_of(fields, [&](const auto& field) { return holds_optional(program, field.type); });
}

void check_fixed_type(Context& c, const Env& env, ast::ExprId written, ir::TypeId fixed) {
    if (!written) return;
    const ir::TypeId type = type_of(c, env, written);
    if (type == fixed || type == c.types().error) return;
    c.error(Diag::type_mismatch, c[written].span, {c.text(fixed), c.text(type)});
}

bool memory_holds(const ir::Program& program, ir::TypeId id) {
    return id != program.types.void_ && !ir::holds_empty(program, id) && !holds_optional(program, id);
}

bool is_refused_optional(Context& c, ir::TypeId type, std::string_view what, Span span) {
    ir::TypeId element = type;
    while (c.types().kind(element) == ir::TypeKind::array) element = c.types()[element].element;
    if (c.types().kind(element) != ir::TypeKind::optional) return false;
    c.error(Diag::optional_here, span, {what, c.text(type)});
    return true;
}

bool becomes(const ir::Types& types, ir::TypeId from, ir::TypeId to) {
    return from == to || (types.kind(to) == ir::TypeKind::optional && becomes(types, from, types[to].element));
}

}  // namespace gliftc::sema
