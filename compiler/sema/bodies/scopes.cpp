#include "sema/bodies/order.h"
#include "sema/names/record.h"

#include <algorithm>

namespace gliftc::sema {

void open_scope(Body& body) { body.scopes.emplace_back(); }

void close_scope(Body& body) {
    // No warnings after errors: code that was skipped because of them may have used the name.
    const bool is_sure = !body.context.diagnostics.has_own_errors();
    std::vector<std::pair<Span, Name>> unused;
    for (const auto& [name, symbol] : body.scopes.back())
        if (is_sure && symbol.warn_unused && !symbol.used && !body.context.text(name).starts_with('_'))
            unused.emplace_back(symbol.span, name);
    std::ranges::sort(unused, {}, [](const auto& one) { return one.first.begin; });
    for (const auto& [span, name] : unused)
        note(body.context.diagnostics.report(Diag::unused_variable, span, {body.context.text(name)}), span,
             "a name that begins with '_' may stay unused");
    body.scopes.pop_back();
}

void declare(Body& body, ast::Identifier name, Symbol symbol) {
    symbol.span = name.span;
    record_use(body.context, name.span, name.span);
    const bool is_structure = symbol.kind == SymbolKind::structure || symbol.kind == SymbolKind::iterator;
    record_type(body.context, name.span, is_structure ? body.types().of_structure(symbol.structure) : symbol.type);
    auto [found, added] = body.scopes.back().emplace(name.name, symbol);
    if (added || !name.name) return;
    note(body.context.error(Diag::duplicate_name, name.span, {body.context.text(name.name)}), found->second.span,
         "first declared here");
}

Symbol* find_symbol(Body& body, Name name) {
    for (auto scope = body.scopes.rbegin(); scope != body.scopes.rend(); ++scope)
        if (auto found = scope->find(name); found != scope->end()) return &found->second;
    return nullptr;
}

ir::LocalId declare_local(Body& body, ast::Identifier name, ir::TypeId type, bool is_mutable, bool warn_unused) {
    ir::LocalId local = add_local(body.program(), name.name, type, name.span, is_mutable);
    Symbol symbol;
    symbol.kind = SymbolKind::local;
    symbol.type = type;
    symbol.local = local;
    symbol.warn_unused = warn_unused;
    declare(body, name, symbol);
    return local;
}

std::optional<ir::Value> known_value(Body& body, ir::ExprId expr) {
    return ir::evaluate(body.program(), expr, body.lets);
}

/// The meaning that a symbol in scope has within a type or a constant expression.
static Meta meta_of_symbol(Body& body, const Symbol& symbol) {
    Meta meta;
    meta.kind = MetaKind::running;
    if (symbol.kind != SymbolKind::local) return meta;
    auto definition = body.lets.find(symbol.local);
    if (definition == body.lets.end()) return meta;
    auto value = known_value(body, definition->second);
    if (!value) return meta;
    meta.kind = MetaKind::value;
    meta.value = std::move(*value);
    return meta;
}

/// Binds the names in scope that an expression uses: they hide outer declarations.
static void bind_symbols(Body& body, ast::ExprId id, std::vector<std::pair<Name, Meta>>& bindings) {
    if (!id) return;
    const ast::Expr& expr = body.context[id];
    for (ast::ExprId operand : expr.operands) bind_symbols(body, operand, bindings);
    if (expr.kind != ast::ExprKind::name) return;
    Symbol* symbol = find_symbol(body, expr.name);
    if (!symbol) return;
    symbol->used = true;
    record_use(body.context, expr.span, symbol->span);
    bindings.emplace_back(expr.name, meta_of_symbol(body, *symbol));
}

const Env& env_for(Body& body, ast::ExprId id) { return env_for(body, std::vector{id}); }

const Env& env_for(Body& body, const std::vector<ast::ExprId>& written) {
    std::vector<std::pair<Name, Meta>> bindings;
    for (ast::ExprId id : written) bind_symbols(body, id, bindings);
    if (bindings.empty()) return body.env;
    // Env::find gives the first binding of a name: those of locals come first, and so hide outer names.
    Env& env = body.context.new_env(body.env.module);
    env.self = body.env.self;
    env.bindings = std::move(bindings);
    env.bindings.insert(env.bindings.end(), body.env.bindings.begin(), body.env.bindings.end());
    return env;
}

void emit(Body& body, ir::StmtId stmt) {
    if (body.block) body.block->push_back(stmt);
}

ir::LocalId emit_temporary(Body& body, std::string_view name, ir::ExprId value, Span span) {
    settle(body, {&value, 1});
    ir::LocalId local =
        add_local(body.program(), body.context.names.intern(name), body.program().exprs[value].type, span);
    ir::StmtId let = add(body.program(), ir::StmtOp::let, span);
    body.program().stmts[let].local = local;
    body.program().stmts[let].value = value;
    emit(body, let);
    return local;
}

}  // namespace gliftc::sema
