#include "emit/glsl/signs.h"

#include "ir/walk.h"

#include <algorithm>
#include <cmath>

namespace gliftc::glsl {

namespace {

using ir::BinaryOp;
using ir::Expr;
using ir::ExprId;
using ir::LocalId;
using ir::Op;
using ir::StmtOp;

bool is_float(const Printer& p, ir::TypeId type) { return p.program.types.scalar_of(type) == p.program.types.float_; }

/// Whether the expression is the constant 0, 1 or -1; `true` and `false` count as 1 and 0.
bool is_small_constant(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    if (expr.op != Op::constant) return false;
    if (p.program.types.is_floating(expr.type)) return expr.number == 0.0 || std::abs(expr.number) == 1.0;
    const auto value = static_cast<std::int64_t>(expr.bits);
    return value >= -1 && value <= 1;
}

bool is_negative_zero(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    return expr.op == Op::constant && is_float(p, expr.type) && expr.number == 0.0 && std::signbit(expr.number);
}

/// Whether the value may be a choice between 0 and 1 or -1, made by a select, step(), the conversion of a bool, a call
/// or assignments, or computed from such a choice by arithmetic. Elements of memory and parameters of the pass are no
/// choices: drivers do not know their values.
bool may_be_choice(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    const auto is_one = [&](ExprId operand) { return may_be_choice(p, operand); };
    switch (expr.op) {
    case Op::local: return p.choices.contains(expr.local);
    case Op::call: return true;
    case Op::intrinsic: return expr.intrinsic == ir::Intrinsic::step;
    case Op::select:
        return std::ranges::any_of(expr.operands.begin() + 1, expr.operands.end(),
                                   [&](ExprId side) { return is_small_constant(p, side) || is_one(side); });
    case Op::convert:
        return p.program.types.scalar_of(p.program.exprs[expr.operands[0]].type) == p.program.types.bool_ ||
               is_one(expr.operands[0]);
    case Op::construct:
    case Op::unary:
    case Op::binary:
    case Op::swizzle:
    case Op::field:
    case Op::value: return std::ranges::any_of(expr.operands, is_one);
    case Op::index: return is_one(expr.operands[0]);
    default: return false;
    }
}

/// Marks the local if what it is set to may be a choice. `is_one_of_several`: a constant may be one side of a choice.
bool mark(Printer& p, LocalId local, ExprId value, bool is_one_of_several) {
    if (!may_be_choice(p, value) && !(is_one_of_several && is_small_constant(p, value))) return false;
    return p.choices.insert(local).second;
}

}  // namespace

void find_choices(Printer& p, const std::vector<LocalId>& params, const std::vector<ir::StmtId>& body) {
    p.choices.insert(params.begin(), params.end());
    bool has_grown = true;
    while (has_grown) {
        has_grown = false;
        ir::for_each_statement(p.program, body, [&](const ir::Stmt& stmt) {
            if (stmt.op == StmtOp::let && stmt.value) {
                has_grown |= mark(p, stmt.local, stmt.value, false);
            } else if (stmt.op == StmtOp::assign) {
                const Expr& place = ir::place_of(p.program, stmt.target);
                if (place.op == Op::local) has_grown |= mark(p, place.local, stmt.value, true);
            }
        });
    }
}

ExprId negated_choice(const Printer& p, const Expr& expr) {
    if (!is_float(p, expr.type)) return {};
    ExprId negated;
    if (expr.op == Op::unary && expr.unary == ir::UnaryOp::minus) negated = expr.operands[0];
    if (expr.op == Op::binary) {
        const ExprId a = expr.operands[0], b = expr.operands[1];
        const auto is_minus_one = [&](ExprId id) {
            const Expr& factor = p.program.exprs[id];
            return factor.op == Op::constant && factor.number == -1.0;
        };
        if (expr.binary == BinaryOp::multiply) negated = is_minus_one(a) ? b : is_minus_one(b) ? a : ExprId{};
        if (expr.binary == BinaryOp::subtract && is_negative_zero(p, a)) negated = b;
    }
    const bool is_lost = negated && !p.program.types.is_matrix(expr.type) &&
                         p.program.exprs[negated].type == expr.type && may_be_choice(p, negated);
    return is_lost ? negated : ExprId{};
}

bool may_be_chosen_negative_zero(const Printer& p, ExprId id) {
    bool found = false;
    if (!is_float(p, p.program.exprs[id].type)) return false;
    ir::for_each_node(p.program, id, [&](ExprId node) {
        const Expr& expr = p.program.exprs[node];
        const bool is_variable = expr.op == Op::local && p.program.locals[expr.local].is_mutable;
        found = found || is_negative_zero(p, node) || (is_variable && p.choices.contains(expr.local));
    });
    return found;
}

std::vector<double> numbers_of(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    const std::uint32_t count = p.program.types.components(expr.type);
    if (expr.op == Op::constant) return {expr.number};
    if (expr.op != Op::construct || (expr.operands.size() != count && expr.operands.size() != 1)) return {};
    std::vector<double> numbers;
    for (ExprId part : expr.operands) {
        const std::vector<double> of_part = numbers_of(p, part);
        numbers.insert(numbers.end(), of_part.begin(), of_part.end());
    }
    if (expr.operands.size() == 1 && numbers.size() == 1) numbers.resize(count, numbers[0]);
    return numbers.size() == count ? numbers : std::vector<double>{};
}

bool is_choice_of_negative_zero(const Printer& p, const Expr& expr) {
    if (expr.op != Op::select || !is_float(p, expr.type) || p.program.types.is_matrix(expr.type)) return false;
    const std::vector<double> yes = numbers_of(p, expr.operands[1]), no = numbers_of(p, expr.operands[2]);
    if (yes.empty() || no.empty()) return false;
    const auto is_small = [](double x) { return x == 0.0 || std::abs(x) == 1.0; };
    const auto is_negative_zero = [](double x) { return x == 0.0 && std::signbit(x); };
    for (std::size_t lane = 0; lane < yes.size(); ++lane) {
        if (!is_small(yes[lane]) || !is_small(no[lane])) continue;
        if (is_negative_zero(yes[lane]) || is_negative_zero(no[lane])) return true;
    }
    return false;
}

}  // namespace gliftc::glsl
