#include "sema/bodies/applied.h"

#include <utility>

namespace gliftc::sema {

namespace {

/// The type of the value that the operand is: of a parameter `each`, that of the current element. Empty for others.
ir::TypeId value_type(Body& body, const Operand& operand) {
    if (operand.kind == OperandKind::value) return operand.type;
    const bool is_element =
        operand.kind == OperandKind::iterator && body.kernel->params[operand.slot].pattern == ir::Pattern::each;
    return is_element ? body.program().structures[operand.structure].element : ir::TypeId{};
}

}  // namespace

ir::TypeId applied_type(Body& body, const Operand& callee) {
    const ir::TypeId type = value_type(body, callee);
    if (!type) return {};
    const ir::TypeKind kind = body.types().kind(type);
    return kind == ir::TypeKind::struct_ || kind == ir::TypeKind::enum_ ? type : ir::TypeId{};
}

bool is_path(const Context& c, ast::ExprId id) {
    const ast::Expr& expr = c[id];
    return expr.kind == ast::ExprKind::name || (expr.kind == ast::ExprKind::member && is_path(c, expr.operands[0]));
}

ast::ExprId applied_call(Context& c, ast::ExprId call) {
    if (const auto made = c.applied_calls.find(call); made != c.applied_calls.end()) return made->second;
    ast::Expr name;
    name.kind = ast::ExprKind::name;
    name.name = c.names.intern("apply");
    name.span = c[c[call].operands[0]].span;
    ast::Expr applied = c[call];
    applied.operands.insert(applied.operands.begin(), c.tree.exprs.add(std::move(name)));
    if (!applied.labels.empty()) applied.labels.insert(applied.labels.begin(), ast::Identifier{});
    const ast::ExprId made = c.tree.exprs.add(std::move(applied));
    c.applied_calls.emplace(call, made);
    return made;
}

}  // namespace gliftc::sema
