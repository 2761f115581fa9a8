#include "lower/transform/fold_constants.h"

#include "ir/evaluate.h"
#include "lower/build/builder.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace gliftc::lower {

using namespace ir;

namespace {

class Folder {
public:
    explicit Folder(Program& program) : p(program), make_(program) {}

    std::vector<StmtId> body(const std::vector<StmtId>& statements) {
        std::vector<StmtId> made;
        for (StmtId id : statements) made.push_back(statement(id));
        return made;
    }

private:
    StmtId statement(StmtId id) {
        const Stmt stmt = p.stmts[id];
        Builder::Parts parts{expression(stmt.target), expression(stmt.value), expression(stmt.limit), body(stmt.body),
                             body(stmt.otherwise)};
        return make_.again(id, std::move(parts));
    }

    ExprId expression(ExprId id) {
        if (!id) return id;
        if (const auto found = made_.find(id); found != made_.end()) return found->second;
        const ExprId made = folded(id);
        made_.emplace(id, made);
        return made;
    }

    ExprId folded(ExprId id) {
        if (const std::optional<Value> value = value_of(id)) return materialize(p, *value, p.exprs[id].span);
        if (const ExprId chosen = chosen_of(p.exprs[id])) return expression(chosen);
        Operands operands;
        for (ExprId operand : p.exprs[id].operands) operands.push_back(expression(operand));
        if (operands == p.exprs[id].operands) return id;
        Expr copy = p.exprs[id];
        copy.operands = std::move(operands);
        return p.exprs.add(std::move(copy));
    }

    /// The value of an operation on constants alone; none if it is anything else or is not to be folded.
    std::optional<Value> value_of(ExprId id) {
        const Expr& expr = p.exprs[id];
        const bool computes = expr.op == Op::convert || expr.op == Op::unary || expr.op == Op::binary ||
                              expr.op == Op::select || expr.op == Op::intrinsic;
        const bool is_number = p.types.is_scalar(expr.type) || p.types.is_vector(expr.type);
        if (!computes || !is_number || !is_of_constants(id)) return std::nullopt;
        const bool is_floating = p.types.is_floating(p.types.scalar_of(expr.type));
        std::optional<Value> value = evaluate(p, id);
        const auto is_finite = [&](const Lane& lane) { return !is_floating || std::isfinite(lane.number); };
        return value && std::ranges::all_of(value->lanes, is_finite) ? value : std::nullopt;
    }

    /// The operand that a select by one constant bool selects; absent for any other expression.
    ExprId chosen_of(const Expr& expr) {
        if (expr.op != Op::select || !p.types.is_scalar(p.exprs[expr.operands[0]].type) ||
            !is_of_constants(expr.operands[0]))
            return {};
        const std::optional<Value> condition = evaluate(p, expr.operands[0]);
        return condition ? expr.operands[condition->bits() ? 1 : 2] : ExprId{};
    }

    bool is_of_constants(ExprId id) {
        const auto found = of_constants_.find(id);
        if (found != of_constants_.end()) return found->second;
        const bool result = is_made_of_constants(p.exprs[id]);
        of_constants_.emplace(id, result);
        return result;
    }

    bool is_made_of_constants(const Expr& expr) {
        switch (expr.op) {
        case Op::constant: return true;
        case Op::binary:
            // Addresses and extents may be computed in 64 bits (widen.h), where sums and products of uints do not wrap.
            if (p.types.scalar_of(expr.type) == p.types.uint) return false;
            [[fallthrough]];
        case Op::construct:
        case Op::convert:
        case Op::unary:
        case Op::select:
        case Op::swizzle:
        case Op::intrinsic:
            return std::ranges::all_of(expr.operands, [&](ExprId operand) { return is_of_constants(operand); });
        default: return false;
        }
    }

    Program& p;
    Builder make_;
    std::unordered_map<ExprId, ExprId> made_;
    std::unordered_map<ExprId, bool> of_constants_;
};

}  // namespace

std::vector<FunctionId> fold_constants(Program& program) {
    Folder folder(program);
    std::vector<FunctionId> changed;
    for (std::uint32_t i = 0; i < program.functions.size(); ++i) {
        const FunctionId id{i};
        if (!program.functions[id].structures.empty())
            continue;  // passes call lowered instances of it (instances.cpp), whose expressions fold as they are made
        std::vector<StmtId> body = folder.body(program.functions[id].body);
        if (body == program.functions[id].body) continue;
        program.functions[id].body = std::move(body);
        changed.push_back(id);
    }
    return changed;
}

}  // namespace gliftc::lower
