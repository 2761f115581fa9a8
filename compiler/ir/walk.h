// Walks over statements and expressions.
#pragma once

#include "base/id_set.h"
#include "ir/ir.h"

namespace gliftc::ir {

/// Calls visit(const Stmt&) for every statement, outer before inner.
template <class Visit> void for_each_statement(const Program& program, const std::vector<StmtId>& body, Visit&& visit) {
    for (StmtId id : body) {
        const Stmt& stmt = program.stmts[id];
        visit(stmt);
        for_each_statement(program, stmt.body, visit);
        for_each_statement(program, stmt.otherwise, visit);
    }
}

/// Whether there is a workgroup or subgroup barrier among the statements, at any depth.
inline bool has_any_barrier(const Program& program, const std::vector<StmtId>& body) {
    bool found = false;
    for_each_statement(program, body, [&](const Stmt& stmt) {
        found = found || stmt.op == StmtOp::barrier || stmt.op == StmtOp::subgroup_barrier;
    });
    return found;
}

/// Whether the body runs the elements of a row in lockstep (lower/host/lockstep.h), if it is of a kernel without a
/// group.
inline bool is_in_lockstep(const Program& program, const std::vector<StmtId>& body) {
    for (StmtId id : body)
        if (program.stmts[id].op == StmtOp::invocations) return true;
    return false;
}

/// The variable or element at the bottom of a chain of indices, fields and components: the object that an assignment or
/// an atomic operation changes.
inline const Expr& place_of(const Program& program, ExprId id) {
    const Expr* expr = &program.exprs[id];
    while (expr->op == Op::index || expr->op == Op::field || expr->op == Op::swizzle)
        expr = &program.exprs[expr->operands[0]];
    return *expr;
}

namespace detail {
template <class Visit> void walk_nodes(const Program& program, ExprId id, IdSet<Expr>& seen, Visit& visit) {
    if (!id || !seen.insert(id)) return;
    visit(id);
    for (ExprId operand : program.exprs[id].operands) walk_nodes(program, operand, seen, visit);
}
}  // namespace detail

/// Calls visit(ExprId) once for every node of an expression.
template <class Visit> void for_each_node(const Program& program, ExprId id, Visit&& visit) {
    IdSet<Expr> seen;
    detail::walk_nodes(program, id, seen, visit);
}

/// The same, but leaves out nodes that are in `seen` and what is below them; adds the visited ones to `seen`.
template <class Visit> void for_each_node(const Program& program, ExprId id, IdSet<Expr>& seen, Visit&& visit) {
    detail::walk_nodes(program, id, seen, visit);
}

/// Calls visit(ExprId) for the root of every expression of one statement, not for the operands below it and not for
/// expressions of statements inside it.
template <class Visit> void for_each_root(const Stmt& stmt, Visit&& visit) {
    if (stmt.value) visit(stmt.value);
    if (stmt.target) visit(stmt.target);
    if (stmt.limit) visit(stmt.limit);
    for (ExprId argument : stmt.arguments) visit(argument);
}

/// Calls visit(ExprId) once for every node of every expression of the statements.
template <class Visit>
void for_each_expression(const Program& program, const std::vector<StmtId>& body, Visit&& visit) {
    IdSet<Expr> seen;
    for_each_statement(program, body, [&](const Stmt& stmt) {
        for_each_root(stmt, [&](ExprId id) { detail::walk_nodes(program, id, seen, visit); });
    });
}

/// Whether the local is an operand in the expression, or in some expression of the statements.
inline bool mentions(const Program& program, ExprId id, LocalId local) {
    bool found = false;
    for_each_node(program, id, [&](ExprId part) { found |= program.exprs[part].local == local; });
    return found;
}
inline bool mentions(const Program& program, const std::vector<StmtId>& body, LocalId local) {
    bool found = false;
    for_each_expression(program, body, [&](ExprId id) { found |= program.exprs[id].local == local; });
    return found;
}

namespace detail {
template <class Visit> void walk_tree(const Program& program, ExprId id, Visit& visit) {
    visit(id);
    for (ExprId operand : program.exprs[id].operands) walk_tree(program, operand, visit);
}
}  // namespace detail

/// for_each_expression without a set of visited nodes: a node with two parents is visited twice. For code whose
/// expressions are trees, as after the pass `share` of lower/, or where a second visit does no harm.
template <class Visit>
void for_each_expression_of_trees(const Program& program, const std::vector<StmtId>& body, Visit&& visit) {
    for_each_statement(program, body, [&](const Stmt& stmt) {
        for_each_root(stmt, [&](ExprId id) { detail::walk_tree(program, id, visit); });
    });
}

}  // namespace gliftc::ir
