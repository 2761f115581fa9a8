// Binary operators: operand types, vector with scalar, matrices.
#include "sema/bodies/order.h"
#include "sema/pipelines/values.h"
#include "sema/types/typing.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

std::string_view text_of(ast::BinaryOp op) {
    switch (op) {
    case ast::BinaryOp::multiply: return "*";
    case ast::BinaryOp::divide: return "/";
    case ast::BinaryOp::remainder: return "%";
    case ast::BinaryOp::add: return "+";
    case ast::BinaryOp::subtract: return "-";
    case ast::BinaryOp::shift_left: return "<<";
    case ast::BinaryOp::shift_right: return ">>";
    case ast::BinaryOp::less: return "<";
    case ast::BinaryOp::less_equal: return "<=";
    case ast::BinaryOp::greater: return ">";
    case ast::BinaryOp::greater_equal: return ">=";
    case ast::BinaryOp::equal: return "==";
    case ast::BinaryOp::not_equal: return "!=";
    case ast::BinaryOp::bit_and: return "&";
    case ast::BinaryOp::bit_xor: return "^";
    case ast::BinaryOp::bit_or: return "|";
    case ast::BinaryOp::logical_and: return "&&";
    case ast::BinaryOp::logical_or: return "||";
    case ast::BinaryOp::otherwise: return "??";
    case ast::BinaryOp::then: return "then";
    }
    return "";
}

enum class Family : std::uint8_t { arithmetic, shift, ordering, equality, bits, logic };

Family family_of(ast::BinaryOp op) {
    switch (op) {
    case ast::BinaryOp::multiply:
    case ast::BinaryOp::divide:
    case ast::BinaryOp::remainder:
    case ast::BinaryOp::add:
    case ast::BinaryOp::subtract: return Family::arithmetic;
    case ast::BinaryOp::shift_left:
    case ast::BinaryOp::shift_right: return Family::shift;
    case ast::BinaryOp::less:
    case ast::BinaryOp::less_equal:
    case ast::BinaryOp::greater:
    case ast::BinaryOp::greater_equal: return Family::ordering;
    case ast::BinaryOp::equal:
    case ast::BinaryOp::not_equal: return Family::equality;
    case ast::BinaryOp::bit_and:
    case ast::BinaryOp::bit_xor:
    case ast::BinaryOp::bit_or: return Family::bits;
    case ast::BinaryOp::logical_and:
    case ast::BinaryOp::logical_or:
    case ast::BinaryOp::otherwise:
    case ast::BinaryOp::then: return Family::logic;
    }
    return Family::logic;
}

ir::BinaryOp lowered(ast::BinaryOp op) {
    static_assert(static_cast<int>(ast::BinaryOp::logical_or) == static_cast<int>(ir::BinaryOp::logical_or));
    return static_cast<ir::BinaryOp>(op);
}

struct Pair {
    ir::ExprId left, right;
};

/// Checks both operands; the type of one is the hint for literals and generic calls in the other. The expected result
/// type is only a hint: in `scale * normal`, of vector type, one operand may be a scalar.
Pair check_sides(Body& body, const ast::Expr& expr, ir::TypeId wanted) {
    ast::ExprId l = expr.operands[0], r = expr.operands[1];
    const Typing left = typing_of(body.context, l), right = typing_of(body.context, r);
    const bool is_shift = family_of(expr.binary) == Family::shift;
    auto hint = [&](ir::ExprId other) {
        const ir::TypeId type = operand_hint(body.types(), body.program().exprs[other].type);
        return body.types().is_matrix(type) ? body.types()[type].element : type;
    };
    Pair pair;
    if (left != Typing::own && right == Typing::own) {
        Alternative first = recorded(body, [&] { return check_hinted(body, r, is_shift ? ir::TypeId{} : wanted); });
        pair.right = first.value;
        const ir::TypeId type = is_shift && wanted ? wanted : hint(pair.right);
        pair.left = check_value(body, l, body.types().scalar_of(type));
        append(body, std::move(first.steps));
    } else {
        pair.left = check_hinted(body, l, wanted);
        const ir::TypeId other = hint(pair.left);
        pair.right = check_hinted(body, r, right == Typing::own ? other : body.types().scalar_of(other));
    }
    return pair;
}

/// The expected type of the operands, where `wanted` is that of the result; absent if it says nothing about them.
ir::TypeId wanted_of_sides(const ir::Types& types, ast::BinaryOp op, ir::TypeId wanted) {
    const Family family = family_of(op);
    const bool compares = family == Family::ordering || family == Family::equality;
    const bool takes_integers = family == Family::bits || family == Family::shift || op == ast::BinaryOp::remainder;
    if (!wanted || compares || (takes_integers && types.is_floating(types.scalar_of(wanted)))) return {};
    return wanted;
}

/// Scalars by how many values they have; 0: not a number. Of two with the same rank neither has all values of the
/// other.
int rank_of(ir::TypeKind scalar) {
    switch (scalar) {
    case ir::TypeKind::int_:
    case ir::TypeKind::uint: return 1;
    case ir::TypeKind::int64:
    case ir::TypeKind::uint64: return 2;
    case ir::TypeKind::half: return 3;
    case ir::TypeKind::float_: return 4;
    case ir::TypeKind::double_: return 5;
    default: return 0;
    }
}

/// The note for operands whose scalars differ: which of them to convert, and to what. It keeps its number of
/// components.
std::string conversion_hint(Body& body, ir::TypeId left, ir::TypeId right) {
    ir::Types& types = body.types();
    const ir::TypeId scalars[] = {types.scalar_of(left), types.scalar_of(right)};
    const int ranks[] = {rank_of(types.kind(scalars[0])), rank_of(types.kind(scalars[1]))};
    const std::string no = "there are no implicit conversions";
    if (ranks[0] == 0 || ranks[1] == 0) return no;
    const auto to = [&](ir::TypeId converted, ir::TypeId scalar) {
        const ir::Type type = types[converted];
        return body.context.text(type.kind == ir::TypeKind::matrix
                                     ? types.matrix(scalar, type.count, type.rows)
                                     : types.vector(scalar, types.components(converted))) +
               "(…)";
    };
    const std::string on_left = "the left side, as in " + to(left, scalars[1]);
    const std::string on_right = "the right side, as in " + to(right, scalars[0]);
    if (ranks[0] == ranks[1]) return no + ": convert " + on_left + ", or " + on_right;
    return no + ": convert " + (ranks[0] < ranks[1] ? on_left : on_right);
}

Operand mismatch(Body& body, const ast::Expr& expr, Pair sides) {
    Context& c = body.context;
    ir::TypeId left = body.program().exprs[sides.left].type, right = body.program().exprs[sides.right].type;
    Diagnostic& diagnostic = c.error(Diag::binary_operands, expr.name_span ? expr.name_span : expr.span,
                                     {text_of(expr.binary), c.text(left), c.text(right)});
    if (body.types().kind(left) == ir::TypeKind::device || body.types().kind(right) == ir::TypeKind::device)
        note(diagnostic, expr.span,
             "a value that lives on the device can be passed on or awaited: 'await' brings it to the host");
    else if (body.types().kind(left) == ir::TypeKind::optional)
        note_optional(body, diagnostic, c[expr.operands[0]].span, left);
    else if (body.types().kind(right) == ir::TypeKind::optional)
        note_optional(body, diagnostic, c[expr.operands[1]].span, right);
    else if (expr.binary == ast::BinaryOp::remainder && body.types().is_floating(body.types().scalar_of(left)))
        note(diagnostic, expr.span, "of floats 'mod(x, y)' is x - y * floor(x / y)");
    else if (body.types().scalar_of(left) != body.types().scalar_of(right))
        note(diagnostic, expr.span, conversion_hint(body, left, right));
    else if (family_of(expr.binary) == Family::equality && left == right &&
             body.types().kind(left) == ir::TypeKind::struct_)
        note(diagnostic, expr.span, "structs of more than 64 members, those of arrays counted, are not compared whole");
    else if (family_of(expr.binary) == Family::ordering && body.types().is_vector(left))
        note(diagnostic, expr.span, "vectors are compared by lessThan, greaterThan …, all and any");
    return error_operand(expr.span);
}

/// The type of a matrix product; none if the shapes do not match.
ir::TypeId matrix_product(ir::Types& types, ir::TypeId left, ir::TypeId right) {
    const ir::Type l = types[left], r = types[right];
    bool lm = l.kind == ir::TypeKind::matrix, rm = r.kind == ir::TypeKind::matrix;
    if (types.scalar_of(left) != types.scalar_of(right)) return {};
    if (lm && rm && l.count == r.rows) return types.matrix(l.element, r.count, l.rows);
    if (lm && r.kind == ir::TypeKind::vector && l.count == r.count) return types.vector(l.element, l.rows);
    if (rm && l.kind == ir::TypeKind::vector && l.count == r.rows) return types.vector(r.element, r.count);
    if (lm && right == l.element) return left;
    if (rm && left == r.element) return right;
    return {};
}

/// The type of an arithmetic, shift or bitwise operation; none if the operand types do not match.
ir::TypeId result_type(ir::Types& types, ast::BinaryOp op, ir::TypeId left, ir::TypeId right) {
    if (types.is_matrix(left) || types.is_matrix(right)) {
        if (op == ast::BinaryOp::multiply) {
            if (ir::TypeId product = matrix_product(types, left, right)) return product;
        }
        return left == right && (op == ast::BinaryOp::add || op == ast::BinaryOp::subtract) ? left : ir::TypeId{};
    }
    ir::TypeId scalar = types.scalar_of(left);
    bool shift = family_of(op) == Family::shift;
    if (shift) {
        if (!types.is_integer(scalar) || !types.is_integer(types.scalar_of(right))) return {};
        if (types.components(right) != 1 && types.components(right) != types.components(left)) return {};
        return left;
    }
    if (scalar != types.scalar_of(right)) return {};
    bool bits = family_of(op) == Family::bits || op == ast::BinaryOp::remainder;
    if (bits ? !types.is_integer(scalar) : !types.is_number(scalar)) return {};
    if (left == right || types.components(right) == 1) return left;
    return types.components(left) == 1 ? right : ir::TypeId{};
}

/// Warns about an integer divisor that is constant and has a component of zero: the result is defined, but probably not
/// meant.
void warn_of_zero(Body& body, ast::BinaryOp op, ir::ExprId divisor, Span span) {
    const auto known = known_value(body, divisor);
    if (!known || std::ranges::none_of(known->lanes, [](const ir::Lane& lane) { return lane.bits == 0; })) return;
    body.context.error(Diag::division_by_zero, span, {op == ast::BinaryOp::divide ? "the dividend" : "zero"});
}

}  // namespace

Operand check_binary(Body& body, ast::ExprId id, ir::TypeId wanted) {
    Context& c = body.context;
    ir::Types& types = body.types();
    const ast::Expr& expr = c[id];
    if (expr.binary == ast::BinaryOp::otherwise) return check_otherwise(body, expr, wanted);
    if (expr.binary == ast::BinaryOp::then) {
        c.error(Diag::not_a_value, expr.span, {"a composition of translators"});
        return error_operand(expr.span);
    }
    Family family = family_of(expr.binary);
    const Parts parts(body);
    if (family == Family::logic) {
        const ir::ExprId left = check_value(body, expr.operands[0], types.bool_);
        Alternative right = recorded(body, [&] { return check_value(body, expr.operands[1], types.bool_); });
        return value_operand(body, choose_logical(body, lowered(expr.binary), left, std::move(right), expr.span),
                             expr.span);
    }
    Pair sides = check_sides(body, expr, wanted_of_sides(types, expr.binary, operand_hint(types, wanted)));
    if (is_error(body, sides.left) || is_error(body, sides.right)) return error_operand(expr.span);
    ir::TypeId left = body.program().exprs[sides.left].type, right = body.program().exprs[sides.right].type;
    ir::TypeId result;
    if (family == Family::equality) {
        if (left != right || !has_equality(body.program(), left)) return mismatch(body, expr, sides);
        if (types.kind(left) == ir::TypeKind::struct_) {
            bool negated = expr.binary == ast::BinaryOp::not_equal;
            return value_operand(body, make_struct_equality(body, negated, sides.left, sides.right, expr.span),
                                 expr.span);
        }
        result = types.bool_;
    } else if (family == Family::ordering) {
        result = left == right && types.is_number(left) ? types.bool_ : ir::TypeId{};
    } else {
        result = result_type(types, expr.binary, left, right);
    }
    if (!result) return mismatch(body, expr, sides);
    if (body.types().is_integer(types.scalar_of(left)) &&
        (expr.binary == ast::BinaryOp::divide || expr.binary == ast::BinaryOp::remainder))
        warn_of_zero(body, expr.binary, sides.right, expr.span);
    return value_operand(
        body, make_binary(body.program(), lowered(expr.binary), result, sides.left, sides.right, expr.span), expr.span);
}

ir::ExprId check_compound(Body& body, const ast::Stmt& stmt, ir::ExprId target) {
    Context& c = body.context;
    ir::Types& types = body.types();
    const Parts parts(body);
    is_target(body, target);
    settle(body);
    const ir::ExprId before = body.program().exprs.add(ir::Expr(body.program().exprs[target]));
    if (is_changeable(body, before)) add_read(body, before);
    ir::TypeId left = body.program().exprs[before].type;
    ir::ExprId value = check_hinted(body, stmt.value, is_flexible(c, stmt.value) ? types.scalar_of(left) : left);
    if (is_error(body, value)) return value;
    ir::TypeId right = body.program().exprs[value].type;
    if (result_type(types, *stmt.op, left, right) != left) {
        Diagnostic& diagnostic = c.error(Diag::binary_operands, stmt.op_span,
                                         {std::string(text_of(*stmt.op)) + "=", c.text(left), c.text(right)});
        if (types.scalar_of(left) != types.scalar_of(right))
            note(diagnostic, c[stmt.value].span,
                 "there are no implicit conversions: write " +
                     c.text(types.vector(types.scalar_of(left), types.components(right))) + "(…)");
        return error_value(body, stmt.span);
    }
    bool divides = *stmt.op == ast::BinaryOp::divide || *stmt.op == ast::BinaryOp::remainder;
    if (divides && types.is_integer(types.scalar_of(left))) warn_of_zero(body, *stmt.op, value, stmt.op_span);
    return make_binary(body.program(), lowered(*stmt.op), left, before, value, stmt.span);
}

}  // namespace gliftc::sema
