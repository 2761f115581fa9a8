#include "lower/build/copy_statements.h"

#include "ir/walk.h"

namespace gliftc::lower {

using namespace ir;

ExprId StatementCopy::of(ExprId id) {
    if (!id) return id;
    if (const ExprId* found = made_.find(id)) return *found;
    const ExprId copy = again(id);
    made_.emplace(id, copy);
    return copy;
}

StmtId StatementCopy::of(StmtId id) {
    Stmt stmt = cx.p.stmts[id];
    stmt.value = of(stmt.value);
    stmt.target = of(stmt.target);
    stmt.limit = of(stmt.limit);
    if (stmt.op == StmtOp::let) declare(stmt);
    for (StmtId& inner : stmt.body) inner = of(inner);
    for (StmtId& inner : stmt.otherwise) inner = of(inner);
    return cx.add(std::move(stmt));
}

ExprId StatementCopy::with_definitions(ExprId id) {
    for_each_node(cx.p, id, [&](ExprId node) {
        const Expr& local = cx.p.exprs[node];
        if (local.op != Op::local) return;
        if (const ExprId* value = cx.definitions.find(local.local)) replace(node, with_definitions(*value));
    });
    return of(id);
}

ExprId StatementCopy::again(ExprId id) {
    const Expr node = cx.p.exprs[id];
    if (node.op == Op::local) {
        const ExprId* found = locals_.find(node.local);
        return found == nullptr ? id : *found;
    }
    Operands operands;
    for (ExprId operand : node.operands) operands.push_back(of(operand));
    if (operands == node.operands) return id;
    const ExprId copy = cx.build.again(node, std::move(operands));
    if (const Name* name = cx.names.find(id)) cx.names.emplace(copy, *name);
    return copy;
}

/// Copies the local that a `let` declares. Uses of an immutable one whose value is a scalar constant are replaced by
/// that constant.
void StatementCopy::declare(Stmt& stmt) {
    const Local local = cx.p.locals[stmt.local];
    const LocalId copy = cx.new_local(local.name, local.type, local.span, local.is_mutable);
    if (cx.definitions.find(stmt.local) != nullptr) cx.definitions[copy] = stmt.value;
    if (const auto limit = cx.build.limits.find(stmt.local); limit != cx.build.limits.end())
        cx.build.limits[copy] = std::uint64_t{limit->second};
    const bool is_constant = stmt.value && !local.is_mutable && cx.build.bits_of(stmt.value);
    locals_[stmt.local] = is_constant ? stmt.value : cx.build.local(copy);
    stmt.local = copy;
}

}  // namespace gliftc::lower
