// Parses expressions with operators, ranges and `then`, and generic arguments, in which only operators that bind at
// least as tightly as `+` may stand outside of parentheses.
#include "syntax/parser_state.h"

#include <algorithm>
#include <array>
#include <optional>

namespace gliftc {

using ast::BinaryOp;
using ast::Expr;
using ast::ExprKind;
using ast::UnaryOp;

namespace {

struct Operator {
    BinaryOp op = {};
    int precedence = 0;
};

/// Precedences are those of C; `??` binds less tightly than `||`. Precedence 0: not a binary operator.
constexpr int least_precedence = 1, additive_precedence = 10;

constexpr auto binary_operators = [] {
    using enum TokenKind;
    std::array<Operator, 128> table{};
    auto set = [&](TokenKind kind, BinaryOp op, int precedence) {
        table[static_cast<std::size_t>(kind)] = {op, precedence};
    };
    set(question_question, BinaryOp::otherwise, least_precedence);
    set(bar_bar, BinaryOp::logical_or, 2);
    set(ampersand_ampersand, BinaryOp::logical_and, 3);
    set(bar, BinaryOp::bit_or, 4);
    set(caret, BinaryOp::bit_xor, 5);
    set(ampersand, BinaryOp::bit_and, 6);
    set(equal_equal, BinaryOp::equal, 7);
    set(exclaim_equal, BinaryOp::not_equal, 7);
    set(less, BinaryOp::less, 8);
    set(less_equal, BinaryOp::less_equal, 8);
    set(greater, BinaryOp::greater, 8);
    set(greater_equal, BinaryOp::greater_equal, 8);
    set(less_less, BinaryOp::shift_left, 9);
    set(greater_greater, BinaryOp::shift_right, 9);
    set(plus, BinaryOp::add, additive_precedence);
    set(minus, BinaryOp::subtract, additive_precedence);
    set(star, BinaryOp::multiply, 11);
    set(slash, BinaryOp::divide, 11);
    set(percent, BinaryOp::remainder, 11);
    return table;
}();

Operator operator_of(TokenKind kind) { return binary_operators[static_cast<std::size_t>(kind)]; }

std::optional<UnaryOp> prefix_of(TokenKind kind) {
    if (kind == TokenKind::plus) return UnaryOp::plus;
    if (kind == TokenKind::minus) return UnaryOp::minus;
    if (kind == TokenKind::exclaim) return UnaryOp::logical_not;
    if (kind == TokenKind::tilde) return UnaryOp::bit_not;
    return std::nullopt;
}

/// The largest height of an expression's tree, over which later stages recurse: the tree of `a + a + …` is one level
/// higher for each operator.
constexpr std::uint16_t highest = 1000;

}  // namespace

ast::ExprId Parser::add(Expr expr) {
    std::uint16_t height = 0;
    for (ExprId operand : expr.operands) height = std::max(height, heights_[operand.index - first_expr_]);
    if (++height > highest) {
        fail(Diag::too_deep, expr.span);
        return error_expr();
    }
    heights_.push_back(height);
    return tree_.exprs.add(std::move(expr));
}

ast::ExprId Parser::error_expr() {
    Expr expr;
    expr.span = here();
    heights_.push_back(1);
    return tree_.exprs.add(std::move(expr));
}

/// expression = range { "then" range } ;
ast::ExprId Parser::parse_expression() {
    std::uint32_t first = cursor_;
    ExprId left = parse_range();
    while (at(TokenKind::kw_then) && !lost_) {
        Expr expr;
        expr.kind = ExprKind::binary;
        expr.binary = BinaryOp::then;
        expr.name_span = span_of(advance());
        expr.operands = {left, parse_range()};
        expr.span = since(first);
        left = add(std::move(expr));
    }
    return left;
}

/// range = conditional [ ".." conditional ] ;
ast::ExprId Parser::parse_range() {
    std::uint32_t first = cursor_;
    ExprId low = parse_conditional();
    if (!at(TokenKind::dot_dot) || lost_) return low;
    Expr expr;
    expr.kind = ExprKind::range;
    expr.name_span = span_of(advance());
    expr.operands = {low, parse_conditional()};
    expr.span = since(first);
    return add(std::move(expr));
}

/// conditional = binary [ "?" conditional ":" conditional ] ;
ast::ExprId Parser::parse_conditional() {
    Nesting nesting(*this);
    if (!nesting.ok) return error_expr();
    std::uint32_t first = cursor_;
    ExprId condition = parse_binary(least_precedence);
    if (!at(TokenKind::question) || lost_) return condition;
    Expr expr;
    expr.kind = ExprKind::conditional;
    set_role(Role::spaced);
    expr.name_span = span_of(advance());
    const bool was_before_colon = std::exchange(is_before_colon_, true);
    expr.operands = {condition, parse_conditional()};
    is_before_colon_ = was_before_colon;
    set_role(Role::spaced);
    expect(TokenKind::colon);
    if (lost_) return error_expr();
    expr.operands.push_back(parse_conditional());
    expr.span = since(first);
    return add(std::move(expr));
}

/// binary = unary { operator unary } ;      grouped by precedence; all operators are left-associative
ast::ExprId Parser::parse_binary(int least) {
    std::uint32_t first = cursor_;
    ExprId left = parse_unary();
    while (!lost_) {
        Operator found = operator_of(peek().kind);
        if (found.precedence < least) break;
        Expr expr;
        expr.kind = ExprKind::binary;
        expr.binary = found.op;
        expr.name_span = span_of(advance());
        ExprId right = parse_binary(found.precedence + 1);
        expr.operands.reserve(2);
        expr.operands.push_back(left);
        expr.operands.push_back(right);
        expr.span = since(first);
        left = add(std::move(expr));
    }
    return left;
}

/// unary = ( "+" | "-" | "!" | "~" | "await" ) unary | postfix ;
ast::ExprId Parser::parse_unary() {
    auto prefix = prefix_of(peek().kind);
    if (!prefix && !at(TokenKind::kw_await)) return parse_postfix();
    Nesting nesting(*this);
    if (!nesting.ok) return error_expr();
    std::uint32_t first = cursor_;
    Expr expr;
    expr.kind = prefix ? ExprKind::unary : ExprKind::await;
    expr.unary = prefix.value_or(UnaryOp::plus);
    set_role(Role::unary);
    expr.name_span = span_of(advance());
    expr.operands = {parse_unary()};
    expr.span = since(first);
    return add(std::move(expr));
}

/// generic-argument = additive { "?" } ;      operators that bind less tightly than `+` need parentheses here
ast::ExprId Parser::parse_generic_argument() {
    Nesting nesting(*this);
    if (!nesting.ok) return error_expr();
    std::uint32_t first = cursor_;
    ExprId argument = parse_binary(additive_precedence);
    while (at_optional_mark() && !lost_) argument = parse_optional(argument, first);
    return argument;
}

}  // namespace gliftc
