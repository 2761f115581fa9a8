#include "lower/host/split_at_derivatives.h"

#include "ir/walk.h"
#include "lower/build/rewrite.h"
#include "lower/host/split_at_barriers.h"

#include <algorithm>
#include <map>

namespace gliftc::lower {

using namespace ir;

namespace {

bool has_derivative(const Program& program, ExprId id) {
    bool found = false;
    if (!id) return found;
    for_each_node(program, id, [&](ExprId node) {
        const Expr& expr = program.exprs[node];
        found = found || (expr.op == Op::intrinsic && is_derivative(expr.intrinsic));
    });
    return found;
}

class Hoisting {
public:
    explicit Hoisting(Context& context) : cx(context) {}

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        for (StmtId id : body) {
            const Stmt stmt = cx.p.stmts[id];
            if (stmt.op == StmtOp::while_ && has_derivative(cx.p, stmt.value)) {
                result.push_back(run_while(id, stmt));
                continue;
            }
            Builder::Parts parts = visited_parts(stmt, [&](ExprId part) { return visit(part, result); });
            meet(result);
            parts.body = run(stmt.body);
            parts.otherwise = run(stmt.otherwise);
            result.push_back(cx.build.again(id, std::move(parts)));
        }
        return result;
    }

private:
    /// A while loop with a derivative in its condition becomes `while true`. Its body begins with the statements that
    /// the condition needs, then `if !condition { break; }`.
    StmtId run_while(StmtId id, const Stmt& stmt) {
        Builder::Parts parts{{}, cx.build.truth(true), {}, {}, {}};
        const ExprId condition = visit(stmt.value, parts.body);
        meet(parts.body);
        Stmt leave = statement(StmtOp::if_, stmt.span);
        leave.value = cx.build.negate(condition);
        leave.body = {cx.add(statement(StmtOp::break_, stmt.span))};
        parts.body.push_back(cx.add(std::move(leave)));
        for (StmtId inner : run(stmt.body)) parts.body.push_back(inner);
        return cx.build.again(id, std::move(parts));
    }

    ExprId visit(ExprId id, std::vector<StmtId>& before) {
        const Expr node = cx.p.exprs[id];
        if (node.op != Op::intrinsic || !is_derivative(node.intrinsic))
            return with_operands_visited(cx, id, [&](ExprId operand) { return visit(operand, before); });
        const bool is_nested = has_derivative(cx.p, node.operands[0]);
        ExprId operand = visit(node.operands[0], before);
        if (is_nested) meet(before);
        if (!is_kept_anyway(operand)) operand = keep(node, operand, before);
        waits_ = true;
        return cx.build.again(node, {operand});
    }

    /// Whether the expression is an immutable local that the fragment part declares. It needs no copy: since the
    /// derivative uses it behind a barrier, a `keep` statement makes it an array with the values of all fragments. An
    /// interpolated value needs a copy, since each loop over fragments computes it anew.
    bool is_kept_anyway(ExprId id) const {
        const Expr& node = cx.p.exprs[id];
        return node.op == Op::local && !cx.p.locals[node.local].is_mutable &&
               std::ranges::none_of(cx.kernel.raster->varyings,
                                    [&](const Varying& varying) { return varying.read == node.local; });
    }

    ExprId keep(const Expr& node, ExprId operand, std::vector<StmtId>& before) {
        const Expr& of = cx.p.exprs[operand];
        const bool is_varying = of.op == Op::local && !cx.p.locals[of.local].is_mutable;
        const LocalId varying = is_varying ? of.local : LocalId{};
        if (const auto found = kept_.find(varying); is_varying && found != kept_.end())
            return cx.build.local(found->second);
        Stmt let = statement(StmtOp::let, node.span);
        let.local = cx.new_local(std::string_view("derived"), cx.build.type(operand), node.span);
        let.value = operand;
        if (is_varying) kept_[varying] = let.local;
        const ExprId kept = cx.build.local(let.local);
        before.push_back(cx.add(std::move(let)));
        return kept;
    }

    void meet(std::vector<StmtId>& before) {
        if (std::exchange(waits_, false)) before.push_back(cx.add(statement(StmtOp::barrier, {})));
        kept_.clear();
    }

    Context& cx;
    std::map<LocalId, LocalId> kept_;  ///< copies of interpolated values, made for the current statement
    bool waits_ = false;               ///< a barrier is needed before the statement, since it has a derivative
};

/// Whether the local passes a value from or to the rasteriser: an interpolated value, a colour or the depth.
/// emit/cpp/host declares these by itself, so that they need no `keep`.
bool is_given(const Raster& raster, LocalId local) {
    const auto is_target = [&](const ColourTarget& target) { return target.value == local; };
    const auto is_varying = [&](const Varying& varying) { return varying.read == local; };
    return std::ranges::any_of(raster.colours, is_target) || std::ranges::any_of(raster.varyings, is_varying) ||
           (raster.depth && raster.depth->value == local);
}

}  // namespace

std::vector<StmtId> split_at_derivatives(Context& cx, const std::vector<StmtId>& body) {
    std::vector<StmtId> split = regions_between_barriers(cx, Hoisting(cx).run(body));
    std::erase_if(split, [&](StmtId id) {
        const Stmt& stmt = cx.p.stmts[id];
        return stmt.op == StmtOp::keep && is_given(*cx.kernel.raster, stmt.local);
    });
    return split;
}

}  // namespace gliftc::lower
