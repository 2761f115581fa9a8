#include "lower/transform/strength.h"

#include "lower/analysis/polynomial.h"

namespace gliftc::lower {

using namespace ir;

namespace {

class Strength {
public:
    explicit Strength(Context& context) : cx(context), numbers_(context), polynomials_(context, numbers_) {}

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        result.reserve(body.size());
        std::size_t visible = candidates_.size();
        for (StmtId id : body) result.push_back(statement_(id));
        candidates_.resize(visible);
        return result;
    }

private:
    /// A local in scope that other sums may be computed from.
    struct Candidate {
        LocalId local;
        const Polynomial* polynomial;
        Polynomial varying;
    };

    StmtId statement_(StmtId id);
    ExprId visit(ExprId id);
    ExprId relative(ExprId id);
    ExprId around_select(const Expr& node, Operands operands);
    bool is_sum(ExprId id) const;
    bool is_step(ExprId id);

    Context& cx;
    Numbers numbers_;
    Polynomials polynomials_;
    std::vector<Candidate> candidates_;
};

bool Strength::is_sum(ExprId id) const {
    const Expr& node = cx.p.exprs[id];
    return node.op == Op::binary && node.type == cx.p.types.uint &&
           (node.binary == BinaryOp::add || node.binary == BinaryOp::subtract || node.binary == BinaryOp::multiply ||
            node.binary == BinaryOp::shift_left);
}

/// Whether the expression is a local plus or minus a uniform amount already.
bool Strength::is_step(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (node.binary != BinaryOp::add && node.binary != BinaryOp::subtract) return false;
    const auto is_local = [&](ExprId part) { return cx.p.exprs[part].op == Op::local; };
    return (is_local(node.operands[0]) && is_uniform(cx, node.operands[1])) ||
           (is_local(node.operands[1]) && is_uniform(cx, node.operands[0]) && node.binary == BinaryOp::add);
}

/// The expression as an earlier local plus or minus an amount that is uniform except for conditions (c ? step : 0);
/// absent: there is no such local, or no gain.
ExprId Strength::relative(ExprId id) {
    if (!is_sum(id) || !numbers_.is_fixed(id) || is_uniform(cx, id)) return {};
    const Polynomial* polynomial = polynomials_.of(id);
    if (polynomial == nullptr) return {};
    Polynomial varying = polynomials_.unchosen(polynomials_.varying(*polynomial));
    if (varying.empty()) return {};
    // A single atom plus a uniform amount, as in x + 1, is as short as it can be.
    if (varying.size() == 1 && varying[0].product.size() == 1 && varying[0].factor == 1) return {};
    const Candidate* best = nullptr;
    Polynomials::Difference nearest;
    for (const Candidate& candidate : candidates_) {
        if (candidate.varying != varying) continue;
        auto difference = polynomials_.difference(*polynomial, *candidate.polynomial);
        if (best && difference.operations >= nearest.operations) continue;
        best = &candidate;
        nearest = std::move(difference);
    }
    if (!best) return {};
    ExprId base = cx.build.local(best->local);
    ExprId amount = polynomials_.expression(nearest.terms);
    if (!amount) return base;
    if (is_step(id)) return {};
    return cx.build.binary(nearest.is_negative ? BinaryOp::subtract : BinaryOp::add, base, amount);
}

/// Makes base + (c ? step : 0) of c ? base + step : base, if step is uniform: both values of the new select are then
/// uniform, so that nothing has to be computed under a branch.
ExprId Strength::around_select(const Expr& node, Operands operands) {
    const Expr* named = &cx.p.exprs[operands[1]];
    // A temporary is used elsewhere, too, so base + step is computed anyway: then the select stays.
    const bool is_own = named->op == Op::local && !cx.p.locals[named->local].is_temporary;
    const ExprId* definition = is_own ? cx.definitions.find(named->local) : nullptr;
    const Expr& moved = definition ? cx.p.exprs[*definition] : *named;
    const Expr& other = cx.p.exprs[operands[2]];
    if (moved.op == Op::binary && (moved.binary == BinaryOp::add || moved.binary == BinaryOp::subtract) &&
        other.op == Op::local) {
        const Expr& base = cx.p.exprs[moved.operands[0]];
        ExprId step = moved.operands[1];
        if (base.op == Op::local && base.local == other.local && is_uniform(cx, step)) {
            BinaryOp op = moved.binary;
            ExprId from = operands[2];
            return cx.build.binary(op, from, cx.build.select(operands[0], step, cx.build.zero(cx.build.type(step))));
        }
    }
    return cx.build.again(node, std::move(operands));
}

ExprId Strength::visit(ExprId id) {
    if (ExprId shorter = relative(id)) return shorter;
    const Expr& node = cx.p.exprs[id];
    if (node.operands.empty() || is_uniform(cx, id)) return id;
    Operands operands;
    for (ExprId operand : node.operands) operands.push_back(visit(operand));
    if (node.op == Op::select && node.type == cx.p.types.uint) return around_select(node, std::move(operands));
    if (operands == node.operands) return id;
    return cx.build.again(node, std::move(operands));
}

StmtId Strength::statement_(StmtId id) {
    const Stmt& stmt = cx.p.stmts[id];
    Builder::Parts parts{stmt.target, stmt.value, stmt.limit, {}, {}};
    const ExprId before = stmt.value;
    if (stmt.value) parts.value = visit(stmt.value);
    if (stmt.target && stmt.op != StmtOp::assign) parts.target = visit(stmt.target);
    parts.body = run(stmt.body);
    parts.otherwise = run(stmt.otherwise);
    if (stmt.op == StmtOp::let && stmt.value && !cx.p.locals[stmt.local].is_mutable) {
        cx.definitions[stmt.local] = parts.value;
        if (cx.build.type(before) == cx.p.types.uint && is_sum(before) && numbers_.is_fixed(before)) {
            if (const Polynomial* polynomial = polynomials_.of(before)) {
                Polynomial varying = polynomials_.unchosen(polynomials_.varying(*polynomial));
                if (!varying.empty()) candidates_.push_back({stmt.local, polynomial, std::move(varying)});
            }
        }
    }
    return cx.build.again(id, std::move(parts));
}

}  // namespace

std::vector<StmtId> strengthen(Context& cx, const std::vector<StmtId>& body) { return Strength(cx).run(body); }

}  // namespace gliftc::lower
