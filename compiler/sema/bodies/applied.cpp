#include "sema/bodies/applied.h"

#include <utility>

namespace gliftc::sema {

ast::ExprId applied_call(Body& body, ast::ExprId call, const Operand& callee) {
    Context& c = body.context;
    const bool is_value = callee.kind == OperandKind::value || callee.kind == OperandKind::iterator;
    if (!is_value) return {};
    const ir::TypeKind kind = body.types().kind(callee.type);
    if (kind != ir::TypeKind::struct_ && kind != ir::TypeKind::enum_) return {};
    if (const auto made = c.applied_calls.find(call); made != c.applied_calls.end()) return made->second;
    ast::Expr name;
    name.kind = ast::ExprKind::name;
    name.name = c.names.intern("apply");
    name.span = callee.span;
    ast::Expr applied = c[call];
    applied.operands.insert(applied.operands.begin(), c.tree.exprs.add(std::move(name)));
    if (!applied.labels.empty()) applied.labels.insert(applied.labels.begin(), ast::Identifier{});
    const ast::ExprId made = c.tree.exprs.add(std::move(applied));
    c.applied_calls.emplace(call, made);
    return made;
}

}  // namespace gliftc::sema
