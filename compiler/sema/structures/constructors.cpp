#include "sema/structures/constructors.h"

#include "sema/bodies/order.h"
#include "sema/names/lookup.h"
#include "sema/structures/components.h"
#include "sema/types/generics.h"
#include "sema/types/instances.h"

namespace gliftc::sema {

namespace {

/// Whether the argument is a name in scope or a path of members from one. Checking such an argument twice is harmless,
/// as that of a closure is: it emits no statements.
bool is_named(Body& body, ast::ExprId id) {
    const ast::Expr* expr = &body.context[id];
    while (expr->kind == ast::ExprKind::member) expr = &body.context[expr->operands[0]];
    return expr->kind == ast::ExprKind::name && find_symbol(body, expr->name) != nullptr;
}

/// The generic structure that a constructor's name denotes; absent if it denotes anything else.
ast::DeclId generic_declaration(Body& body, const ast::Expr& name) {
    Context& c = body.context;
    if (name.kind != ast::ExprKind::name || body.env.find(name.name)) return {};
    const Visible visible = look_up(c, body.env.module, {name.name, name.span});
    if (visible.found.size() != 1) return {};
    const ast::Decl& decl = c[visible.found[0]];
    return constructor_of(decl) && !decl.generics.empty() ? visible.found[0] : ast::DeclId{};
}

/// A copy of a default in which `values` replace the arguments of the constructor.
ir::ExprId with_values(ir::Program& program, ir::ExprId id, const std::vector<ir::ExprId>& values) {
    ir::Expr expr = program.exprs[id];
    if (expr.op == ir::Op::member) return values[expr.slot];
    for (ir::ExprId& operand : expr.operands) operand = with_values(program, operand, values);
    return program.exprs.add(std::move(expr));
}

}  // namespace

const std::vector<ast::Param>* constructor_of(const ast::Decl& decl) {
    const auto* structure = std::get_if<ast::Structure>(&decl.body);
    return structure != nullptr ? &structure->constructor : nullptr;
}

const std::vector<ast::Item>& items_of(const ast::Decl& decl) { return std::get<ast::Structure>(decl.body).items; }

std::vector<const ast::Item*> items_of(Context& c, ir::StructureId structure) {
    std::vector<const ast::Item*> items;
    for_each_item(c, *c.structure_env.at(structure), items_of(c[c.structure_decl.at(structure)]),
                  [&](const ast::Item& item) { items.push_back(&item); });
    return items;
}

Meta constructed_type(Body& body, const ast::Expr& call) {
    Context& c = body.context;
    const ast::ExprId written = call.operands[0];
    const ast::Expr& callee = c[written];
    const bool has_generics = callee.kind == ast::ExprKind::generic;
    const ast::DeclId id = generic_declaration(body, has_generics ? c[callee.operands[0]] : callee);
    if (!id || (has_generics && callee.operands.size() > c[id].generics.size()))
        return meta_of(c, env_for(body, written), written);
    Env& env = c.new_env(c.module_of.at(id));
    Arguments generics(c, c[id], env, callee.span);
    std::vector<ast::ExprId> given;
    if (has_generics) given.assign(callee.operands.begin() + 1, callee.operands.end());
    if (!generics.give(env_for(body, written), given)) return {};
    const std::vector<ast::Param>& params = *constructor_of(c[id]);
    for (std::size_t i = 0; i < params.size() && i + 1 < call.operands.size(); ++i) {
        const bool is_closure = c[call.operands[i + 1]].kind == ast::ExprKind::closure;
        if (!is_closure && !is_named(body, call.operands[i + 1])) continue;
        const Operand argument = check(body, call.operands[i + 1]);
        if (argument.kind == OperandKind::error) return {};
        if (is_closure) generics.infer(params[i].type, argument.type);
        if (argument.kind == OperandKind::structure) generics.infer_structure(params[i].type, argument.structure);
    }
    if (!generics.finish()) return {};
    const ir::TypeId type = instantiate_type(c, id, env, callee.span);
    if (type == c.types().error) return {};
    Meta meta;
    meta.kind = MetaKind::type;
    meta.type = type;
    return meta;
}

ir::ExprId default_of(Body& earlier, const ast::Param& param, ir::TypeId type) {
    Context& c = earlier.context;
    if (!param.default_value) return {};
    if (c.types().kind(type) == ir::TypeKind::structure) {
        c.error(Diag::default_of_structure, c[param.default_value].span, {c.text(param.name.name)});
        return {};
    }
    const ir::ExprId value = check_value(earlier, param.default_value, type);
    const std::optional<ir::Value> known = known_value(earlier, value);
    return known ? ir::materialize(c.program, *known, c[param.default_value].span) : value;
}

bool has_argument_count(Context& c, ir::StructureId structure, const ast::Expr& call) {
    const ast::Decl& decl = c[c.structure_decl.at(structure)];
    const std::vector<ast::Param>& params = *constructor_of(decl);
    const std::size_t given = call.operands.size() - 1, most = params.size();
    std::size_t least = most;
    while (least > 0 && params[least - 1].default_value) --least;
    if (given >= least && given <= most) return true;
    const std::string few = least < most ? std::to_string(least) + (least + 1 < most ? " to " : " or ") : "";
    note(c.error(Diag::argument_count, call.span,
                 {c.program.structures[structure].display, few + std::to_string(most), std::to_string(given)}),
         decl.name.span, "declared here");
    return false;
}

ir::Operands omitted_arguments(Body& body, ir::StructureId structure, std::vector<ir::ExprId> values) {
    const std::vector<ir::ExprId> defaults = body.program().structures[structure].defaults;
    if (values.size() < defaults.size() && body.block) settle(body);
    ir::Operands omitted;
    while (values.size() < defaults.size()) {
        values.push_back(with_values(body.program(), defaults[values.size()], values));
        omitted.push_back(values.back());
    }
    return omitted;
}

}  // namespace gliftc::sema
