// Walks over expressions and statements.
#pragma once

#include "ir/ir.h"

namespace gliftc::cpp {

/// Calls `visit(const ir::Expr&)` for the expression and all of its operands; functions called are not entered.
template <class Visit> void for_each_expression(const ir::Program& program, ir::ExprId id, const Visit& visit) {
    if (!id) return;
    const ir::Expr& expr = program.exprs[id];
    visit(expr);
    for (ir::ExprId operand : expr.operands) for_each_expression(program, operand, visit);
}

/// Calls `visit(const ir::Stmt&)` for all statements, outer ones first.
template <class Visit>
void for_each_statement(const ir::Program& program, const std::vector<ir::StmtId>& body, const Visit& visit) {
    for (ir::StmtId id : body) {
        const ir::Stmt& stmt = program.stmts[id];
        visit(stmt);
        for_each_statement(program, stmt.body, visit);
        for_each_statement(program, stmt.otherwise, visit);
    }
}

/// All expressions of all statements.
template <class Visit>
void for_each_expression(const ir::Program& program, const std::vector<ir::StmtId>& body, const Visit& visit) {
    for_each_statement(program, body, [&](const ir::Stmt& stmt) {
        for_each_expression(program, stmt.target, visit);
        for_each_expression(program, stmt.value, visit);
        for_each_expression(program, stmt.limit, visit);
        for (ir::ExprId argument : stmt.arguments) for_each_expression(program, argument, visit);
    });
}

inline bool mentions(const ir::Program& program, const std::vector<ir::StmtId>& body, ir::LocalId local) {
    bool found = false;
    for_each_expression(program, body, [&](const ir::Expr& expr) { found |= expr.local == local; });
    return found;
}

/// "[[maybe_unused]] " before a parameter that the body has no use for.
inline const char* unused_mark(const ir::Program& program, const std::vector<ir::StmtId>& body, ir::LocalId local) {
    return mentions(program, body, local) ? "" : "[[maybe_unused]] ";
}

}  // namespace gliftc::cpp
