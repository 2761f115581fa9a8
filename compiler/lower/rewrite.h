// What passes that replace parts of expressions do with the rest.
#pragma once

#include "lower/context.h"

namespace gliftc::lower {

/// The node with what `visit` makes of its operands, as it stands: nothing is folded. Itself where they stay.
template <class Visit> ExprId with_operands_visited(Context& cx, ExprId id, Visit&& visit) {
    const ir::Expr& node = cx.p.exprs[id];
    Operands operands;
    for (ExprId operand : node.operands) operands.push_back(visit(operand));
    if (operands == node.operands) return id;
    ir::Expr copy = node;
    copy.operands = std::move(operands);
    return cx.p.exprs.add(std::move(copy));
}

/// What `visit` makes of a statement's expressions; without the statements inside it.
template <class Visit> Make::Parts visited_parts(const ir::Stmt& stmt, Visit&& visit) {
    Make::Parts parts;
    if (stmt.value) parts.value = visit(stmt.value);
    if (stmt.target) parts.target = visit(stmt.target);
    if (stmt.limit) parts.limit = visit(stmt.limit);
    return parts;
}

}  // namespace gliftc::lower
