// Generic arguments that only the result of a closure determines.
#include "sema/bodies/closures.h"
#include "sema/types/generics.h"

#include <algorithm>

namespace gliftc::sema {

/// Whether the expression names no generic parameter without an argument.
bool Arguments::is_known(ast::ExprId expr) const {
    if (!expr) return false;
    if (const auto i = index_of(expr)) return found[*i].has_value();
    return std::ranges::all_of(context[expr].operands, [&](ast::ExprId part) { return is_known(part); });
}

namespace {

/// The function of an interface that has no other one; null if it has none or several.
const ast::Function* only_function(const Context& c, const ast::Decl& interface) {
    const auto& members = std::get<ast::Interface>(interface.body).members;
    return members.size() == 1 ? std::get_if<ast::Function>(&c[members[0]].body) : nullptr;
}

}  // namespace

/// Infers K of the constraint `Function<T, K>`, if nothing else determines it: the closure gives a K for a T.
void Arguments::infer_from_result(ast::ExprId constraint, ir::TypeId closure) {
    Context& c = context;
    const ast::Expr& expr = c[constraint];
    if (expr.kind != ast::ExprKind::generic || c[expr.operands[0]].kind != ast::ExprKind::name) return;
    Env known = env;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i]) known.bindings.emplace_back(decl.generics[i].name.name, *found[i]);
    const Meta meaning = find_meta(c, known, {c[expr.operands[0]].name, expr.span});
    if (meaning.kind != MetaKind::declarations) return;
    const ast::Decl& interface = c[meaning.declarations[0]];
    if (!std::holds_alternative<ast::Interface>(interface.body)) return;
    const ast::Function* function = only_function(c, interface);
    if (!function || interface.generics.size() + 1 != expr.operands.size()) return;
    Env inside;
    inside.module = c.module_of.at(meaning.declarations[0]);
    inside.self = closure;
    Arguments written(c, interface, inside, use);
    for (std::size_t i = 1; i < expr.operands.size(); ++i)
        if (is_known(expr.operands[i])) written.found[i - 1] = meta_of(c, known, expr.operands[i]);
    const auto result = written.index_of(function->result);
    if (!result || written.found[*result]) return;
    std::vector<ir::TypeId> params;
    for (std::size_t i = 0; i < interface.generics.size(); ++i)
        if (written.found[i]) inside.bindings.emplace_back(interface.generics[i].name.name, *written.found[i]);
    for (std::size_t i = 1; i < function->params.size(); ++i) {
        if (!written.is_known(function->params[i].type)) return;
        params.push_back(type_of(c, inside, function->params[i].type));
    }
    if (const ir::TypeId type = result_of_call(c, closure, params)) infer(expr.operands[*result + 1], type);
}

}  // namespace gliftc::sema
