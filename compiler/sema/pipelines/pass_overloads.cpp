#include "sema/pipelines/pass_overloads.h"

#include "sema/types/specificity.h"
#include "sema/types/typing.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

const std::vector<ast::Param>& params_of(const ast::Decl& decl) {
    if (const auto* kernel = std::get_if<ast::Kernel>(&decl.body)) return kernel->params;
    return std::get<ast::Pipeline>(decl.body).params;
}

/// Whether the type of the argument fits the parameter; of literals, whether they can take the parameter's type. `none`
/// and braced lists fit any parameter but a range.
bool takes(Body& body, const Env& env, const ast::Param& param, const PassArgument& argument) {
    Context& c = body.context;
    if (param.pattern == ast::Pattern::range) {
        if (!argument.structure || param.extra.size() != 1) return false;
        const ir::Structure structure = c.program.structures[argument.structure];
        const auto axes = count_of(c, env, param.type);
        return axes && structure.domain_type == c.types().vector(c.types().uint, *axes) &&
               structure.element == type_of(c, env, param.extra[0]);
    }
    const ir::TypeId wanted = type_of(c, env, param.type);
    if (argument.structure) return wanted == c.types().of_structure(argument.structure);
    if (!argument.waits) return argument.type && becomes(c.types(), argument.type, wanted);
    if (!is_flexible(c, argument.written)) return true;
    const ir::TypeId taken = operand_hint(c.types(), wanted), own = own_type(c, argument.written);
    if (!c.types().is_number(taken)) return false;
    return own != c.types().float_ || c.types().is_floating(taken);
}

/// The parameters for which the call gives arguments: without the `at` parameter where its argument is omitted.
std::vector<ast::Param> given_params(const ast::Decl& decl, std::size_t arguments) {
    std::vector<ast::Param> params = params_of(decl);
    if (arguments + 1 != params.size() || !std::holds_alternative<ast::Kernel>(decl.body)) return params;
    if (const auto left_out = only_address(params))
        params.erase(params.begin() + static_cast<std::ptrdiff_t>(*left_out));
    return params;
}

bool is_viable(Body& body, ast::DeclId id, const std::vector<ast::ExprId>& generics,
               const std::vector<PassArgument>& arguments, const ast::Expr& call, const Operand* owner) {
    Context& c = body.context;
    const std::vector<ast::Param> params = given_params(c[id], arguments.size());
    if (params.size() != arguments.size() || generics.size() > c[id].named_generics().size()) return false;
    Env env;
    env.module = c.module_of.at(id);
    if (owner) env.bindings = c.structure_env.at(owner->structure)->bindings;
    Arguments bound(c, c[id], env, call.span);
    if (!bound.give(env_for(body, generics), generics, 0, true)) return false;
    infer_arguments(body, bound, params, arguments);
    if (!bound.finish(true)) return false;
    for (std::size_t i = 0; i < params.size(); ++i)
        if (!takes(body, env, params[i], arguments[i])) return false;
    return true;
}

bool is_better(const Context& c, ast::DeclId a, ast::DeclId b) {
    if (is_more_special(c, c[a], c[b])) return true;
    if (is_more_special(c, c[b], c[a])) return false;
    return c[a].generics.empty() && !c[b].generics.empty();
}

}  // namespace

std::optional<std::size_t> only_address(const std::vector<ast::Param>& params) {
    const auto is_address = [](const ast::Param& param) { return param.pattern == ast::Pattern::at; };
    if (std::ranges::count_if(params, is_address) != 1) return std::nullopt;
    return static_cast<std::size_t>(std::ranges::find_if(params, is_address) - params.begin());
}

void infer_arguments(Body& body, Arguments& generics, const std::vector<ast::Param>& params,
                     const std::vector<PassArgument>& arguments) {
    for (std::size_t i = 0; i < params.size() && i < arguments.size(); ++i) {
        generics.locate(params[i].type, arguments[i].written);
        if (arguments[i].waits) continue;
        if (params[i].pattern == ast::Pattern::range && arguments[i].structure) {
            const ir::Structure structure = body.program().structures[arguments[i].structure];
            generics.infer_value(params[i].type, {body.types().uint,
                                                  {ir::Lane{.bits = body.types().components(structure.domain_type)}}});
            if (!params[i].extra.empty()) generics.infer(params[i].extra[0], structure.element);
        } else if (arguments[i].structure) {
            generics.infer_structure(params[i].type, arguments[i].structure);
        } else if (arguments[i].type) {
            generics.infer(params[i].type, arguments[i].type);
        }
    }
    for (std::size_t i = 0; i < params.size() && i < arguments.size(); ++i)
        if (arguments[i].waits) infer_from_literal(generics, params[i].type, arguments[i].written);
}

std::optional<ast::DeclId> choose_pass(Body& body, const std::vector<ast::DeclId>& overloads,
                                       const std::vector<ast::ExprId>& generics,
                                       const std::vector<PassArgument>& arguments, const ast::Expr& call,
                                       const Operand* owner) {
    Context& c = body.context;
    if (overloads.size() == 1) return overloads[0];
    std::vector<ast::DeclId> fitting;
    for (ast::DeclId id : overloads)
        if (is_viable(body, id, generics, arguments, call, owner)) fitting.push_back(id);
    if (fitting.empty()) {
        Diagnostic& diagnostic = c.error(Diag::no_overload, call.span, {c.text(c[overloads[0]].name.name)});
        for (ast::DeclId id : overloads) note(diagnostic, c[id].name.span, "does not take these arguments");
        return std::nullopt;
    }
    ast::DeclId best = fitting[0];
    for (ast::DeclId id : fitting)
        if (is_better(c, id, best)) best = id;
    const auto is_as_good = [&](ast::DeclId id) { return id != best && !is_better(c, best, id); };
    if (std::ranges::none_of(fitting, is_as_good)) return best;
    Diagnostic& diagnostic = c.error(Diag::ambiguous_call, call.span, {c.text(c[best].name.name)});
    for (ast::DeclId id : fitting) note(diagnostic, c[id].name.span, "fits");
    return std::nullopt;
}

}  // namespace gliftc::sema
