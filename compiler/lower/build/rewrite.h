// Helpers for passes that replace parts of expressions: they rebuild the nodes around the replaced parts.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// The node with each operand replaced by visit(operand); nothing is folded. The node itself if no operand changes.
template <class Visit> ExprId with_operands_visited(Context& cx, ExprId id, Visit&& visit) {
    const ir::Expr& node = cx.p.exprs[id];
    Operands operands;
    for (ExprId operand : node.operands) operands.push_back(visit(operand));
    if (operands == node.operands) return id;
    ir::Expr copy = node;
    copy.operands = std::move(operands);
    return cx.p.exprs.add(std::move(copy));
}

/// A statement's target, value and limit, each replaced by visit(expression); its inner statements are left out.
template <class Visit> Builder::Parts visited_parts(const ir::Stmt& stmt, Visit&& visit) {
    Builder::Parts parts;
    if (stmt.value) parts.value = visit(stmt.value);
    if (stmt.target) parts.target = visit(stmt.target);
    if (stmt.limit) parts.limit = visit(stmt.limit);
    return parts;
}

/// The statements with each expression replaced by visit(expression), also inside of statements. take(stmt, value,
/// result), where `value` is visit(stmt.value), may replace or drop a statement: it then puts what replaces the
/// statement, if anything, into `result`, and returns true.
template <class Visit, class Take>
std::vector<StmtId> rebuilt(Context& cx, const std::vector<StmtId>& body, Visit& visit, Take& take) {
    std::vector<StmtId> result;
    result.reserve(body.size());
    for (StmtId id : body) {
        const ir::Stmt stmt = cx.p.stmts[id];
        Builder::Parts parts = visited_parts(stmt, visit);
        if (take(stmt, parts.value, result)) continue;
        parts.body = rebuilt(cx, stmt.body, visit, take);
        parts.otherwise = rebuilt(cx, stmt.otherwise, visit, take);
        result.push_back(cx.build.again(id, std::move(parts)));
    }
    return result;
}

}  // namespace gliftc::lower
