// Which function a call means, and the call itself: overloads, their generic arguments, their arguments.
#include "sema/body.h"
#include "sema/generics.h"
#include "sema/instances.h"
#include "sema/lookup.h"
#include "sema/specificity.h"
#include "sema/typing.h"

namespace gliftc::sema {

namespace {

/// One overload that fits, and how well.
struct Candidate {
    ast::DeclId decl;
    std::unique_ptr<Env> env;
    ir::TypeId result;
    bool gives_wanted = true;
    bool is_generic = false;
    bool takes_as_they_are = true;  ///< no value becomes an optional
    bool takes_literals = true;     ///< as the types that they have on their own
};

struct CheckedArguments {
    std::vector<Operand> operands;  ///< kind error and no span for those that wait for their parameter's type
    std::vector<bool> waits;
    bool failed = false;
};

ir::TypeId operand_type(Body& body, const Operand& operand) {
    if (operand.kind == OperandKind::value) return operand.type;
    if (operand.kind == OperandKind::structure) return body.types().of_structure(operand.structure);
    return {};
}

CheckedArguments check_arguments(Body& body, const std::vector<ast::ExprId>& arguments) {
    CheckedArguments result;
    for (ast::ExprId argument : arguments) {
        bool waits = waits_for_parameter(body.context, argument);
        Operand operand;
        if (!waits) {
            operand = check(body, argument);
            if (operand.kind == OperandKind::iterator) {
                const ir::KernelParam& param = body.kernel->params[operand.slot];
                if (param.pattern != ir::Pattern::near && param.pattern != ir::Pattern::scatter)
                    operand = value_operand(body, to_value(body, operand), operand.span);
                else
                    operand.kind = OperandKind::structure, operand.place.root = operand.slot,
                    operand.window = param.radius;
            }
            if (operand.kind == OperandKind::error) result.failed = true;
        }
        result.operands.push_back(std::move(operand));
        result.waits.push_back(waits);
    }
    return result;
}

/// Binds the generics of an overload; null if it does not fit. With `report`, says why.
std::unique_ptr<Env> match(Body& body, ast::DeclId id, const Env* owner,
                           const std::vector<ast::ExprId>& explicit_generics, const CheckedArguments& arguments,
                           const ast::Expr& call, ir::TypeId wanted, bool report) {
    Context& c = body.context;
    const ast::Decl& decl = c[id];
    const auto& function = std::get<ast::Function>(decl.body);
    auto env = std::make_unique<Env>();
    if (owner) *env = *owner;
    env->module = c.module_of.at(id);
    if (function.params.size() != arguments.operands.size()) {
        if (report)
            note(c.error(Diag::argument_count, call.span,
                         {c.text(decl.name.name), std::to_string(function.params.size()),
                          std::to_string(arguments.operands.size())}),
                 decl.name.span, "declared here");
        return nullptr;
    }
    Arguments generics(c, decl, *env, call.span);
    if (!report && explicit_generics.size() > decl.generics.size()) return nullptr;
    if (!explicit_generics.empty() && !generics.give(env_for(body, explicit_generics), explicit_generics))
        return nullptr;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        if (arguments.waits[i]) continue;
        if (arguments.operands[i].kind == OperandKind::structure)
            generics.infer_structure(function.params[i].type, arguments.operands[i].structure);
        else if (ir::TypeId type = operand_type(body, arguments.operands[i]))
            generics.infer(function.params[i].type, type);
    }
    if (wanted && function.result) generics.infer(function.result, wanted);
    for (std::size_t i = 0; i < function.group.size() && i < 3 && body.grouped(); ++i)
        generics.infer_value(function.group[i], {body.types().uint, {ir::Lane{.bits = body.group[i]}}});
    for (std::size_t i = 0; i < function.params.size(); ++i)
        if (arguments.waits[i]) infer_from_literal(generics, function.params[i].type, call.operands[i + 1]);
    if (!generics.finish(!report)) return nullptr;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        if (arguments.waits[i] || arguments.operands[i].kind == OperandKind::error) continue;
        ir::TypeId parameter = type_of(c, *env, function.params[i].type);
        ir::TypeId actual = operand_type(body, arguments.operands[i]);
        if (parameter == body.types().error || (actual && becomes(body.types(), actual, parameter))) continue;
        if (!report) return nullptr;
        if (!actual) to_value(body, arguments.operands[i]);  // reports that it is no value
        else {
            Diagnostic& diagnostic =
                c.error(Diag::type_mismatch, arguments.operands[i].span, {c.text(parameter), c.text(actual)});
            note(diagnostic, function.params[i].name.span,
                 "parameter '" + c.text(function.params[i].name.name) + "' is declared here");
        }
        return nullptr;
    }
    return env;
}

/// A function's window must lie within that of the kernel.
bool fits_window(Body& body, const Env& env, const ast::Param& param, const Operand& argument) {
    if (param.pattern != ast::Pattern::near) return true;
    std::uint32_t radius = window_radius(body.context, env, param);
    if (radius <= argument.window) return true;
    Context& c = body.context;
    note(c.error(Diag::window, argument.span, {c.text(param.name.name), std::to_string(radius)}), param.name.span,
         "pass a parameter that the kernel declares as near<…, " + std::to_string(radius) + ">");
    return false;
}

/// What a function shares between workgroups must be shared by the kernel.
bool fits_coherent(Body& body, const ast::Param& param, const Operand& argument) {
    if (param.pattern != ast::Pattern::coherent || argument.is_coherent) return true;
    Context& c = body.context;
    note(c.error(Diag::coherent_argument, argument.span, {c.text(param.name.name)}), param.name.span,
         "pass a parameter that the kernel declares as inout coherent<…>");
    return false;
}

/// A function with a workgroup is called by kernels and functions with the same one.
bool fits_group(Body& body, ast::DeclId id, const Env& env, const ast::Expr& call) {
    Context& c = body.context;
    const auto& function = std::get<ast::Function>(c[id].body);
    if (function.group.empty()) return true;
    if (!body.grouped()) {
        note(c.error(Diag::needs_group, call.span, {c.text(c[id].name.name)}), c[id].name.span,
             "it works with a whole workgroup: write 'group(size)' after the parameters of what calls it");
        return false;
    }
    const auto wanted = group_of(c, env, function.group);
    if (wanted == body.group) return true;
    const auto text = [](const std::array<std::uint32_t, 3>& group) {
        return std::to_string(group[0]) + " x " + std::to_string(group[1]) + " x " + std::to_string(group[2]);
    };
    note(c.error(Diag::group_differs, call.span, {c.text(c[id].name.name), text(wanted), text(body.group)}),
         c[id].name.span, "declared here");
    return false;
}

/// Finishes a call of a matched function: the waiting arguments, then the call node.
Operand finish_call(Body& body, ast::DeclId id, const Env& env, CheckedArguments& arguments,
                    const std::vector<ast::ExprId>& written, const ast::Expr& call, const Operand* self) {
    Context& c = body.context;
    const auto& function = std::get<ast::Function>(c[id].body);
    ir::Operands values;
    std::vector<std::uint32_t> structures;
    std::vector<ir::Place> places;
    if (self) {
        structures.push_back(self->structure);
        places.push_back(self->place);
    }
    for (std::size_t i = 0; i < written.size(); ++i) {
        Operand& operand = arguments.operands[i];
        if (operand.kind == OperandKind::structure) {
            if (!fits_window(body, env, function.params[i], operand)) return error_operand(call.span);
            if (!fits_coherent(body, function.params[i], operand)) return error_operand(call.span);
            structures.push_back(operand.structure);
            places.push_back(operand.place);
            continue;
        }
        ir::TypeId parameter = type_of(c, env, function.params[i].type);
        values.push_back(arguments.waits[i] ? check_value(body, written[i], parameter)
                                            : coerce(body, to_value(body, operand), parameter, operand.span));
        if (is_error(body, values.back())) return error_operand(call.span);
    }
    if (!fits_group(body, id, env, call)) return error_operand(call.span);
    auto instance = instantiate_function(c, id, env, structures, call.span);
    if (!instance) return error_operand(call.span);
    ir::ExprId result =
        add(body.program(), ir::Op::call, body.program().functions[*instance].result, call.span, std::move(values));
    body.program().exprs[result].function = *instance;
    body.program().exprs[result].places = std::move(places);
    return value_operand(body, result, call.span);
}

/// Does a function's result serve where `wanted` is? Everything serves where nothing is wanted.
bool gives(Body& body, ir::TypeId result, ir::TypeId wanted) {
    return !wanted || becomes(body.types(), result, wanted);
}

std::optional<Candidate> try_overload(Body& body, ast::DeclId id, const Env* owner,
                                      const std::vector<ast::ExprId>& generics, const CheckedArguments& arguments,
                                      const ast::Expr& call, ir::TypeId wanted) {
    Context& c = body.context;
    auto env = match(body, id, owner, generics, arguments, call, wanted, false);
    if (!env && wanted) env = match(body, id, owner, generics, arguments, call, {}, false);
    if (!env) return std::nullopt;
    Candidate candidate;
    candidate.decl = id;
    const auto& function = std::get<ast::Function>(c[id].body);
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ir::TypeId given = operand_type(body, arguments.operands[i]);
        if (!arguments.waits[i] && given)
            candidate.takes_as_they_are &= given == type_of(c, *env, function.params[i].type);
        ast::ExprId literal = call.operands[i + 1];
        if (!is_flexible(c, literal)) continue;
        const ir::TypeId own = operand_hint(c.types(), own_type(c, literal));
        const ir::TypeId taken = operand_hint(c.types(), type_of(c, *env, function.params[i].type));
        if (own == c.types().float_ && !c.types().is_floating(c.types().scalar_of(taken))) return std::nullopt;
        candidate.takes_literals &= own == taken;
    }
    ast::ExprId result = function.result;
    ir::TypeId type = result ? type_of(c, *env, result) : c.types().void_;
    candidate.env = std::move(env);
    candidate.result = type;
    candidate.gives_wanted = gives(body, type, wanted);
    candidate.is_generic = !c[id].generics.empty();
    return candidate;
}

/// What is wanted decides first; then the one that makes no optionals of the arguments; then the one written more
/// closely for these types; then the types that literals have on their own.
bool is_better(const Context& c, const Candidate& a, const Candidate& b) {
    if (a.gives_wanted != b.gives_wanted) return a.gives_wanted;
    if (a.takes_as_they_are != b.takes_as_they_are) return a.takes_as_they_are;
    if (is_more_special(c, c[a.decl], c[b.decl])) return true;
    if (is_more_special(c, c[b.decl], c[a.decl])) return false;
    if (a.is_generic != b.is_generic) return !a.is_generic;
    return a.takes_literals && !b.takes_literals;
}

/// Nothing tells one from the other: they are as good, and take the same.
bool is_ambiguous(Body& body, const Candidate& a, const Candidate& b) {
    if (is_better(body.context, a, b) || is_better(body.context, b, a)) return false;
    Context& c = body.context;
    const auto& left = std::get<ast::Function>(c[a.decl].body).params;
    const auto& right = std::get<ast::Function>(c[b.decl].body).params;
    for (std::size_t i = 0; i < left.size(); ++i)
        if (type_of(c, *a.env, left[i].type) != type_of(c, *b.env, right[i].type)) return false;
    return true;
}

/// The best of several overloads, the first where some are as good; reports where there is none, or no best.
std::optional<Candidate> choose(Body& body, const std::vector<ast::DeclId>& overloads, const Env* owner,
                                const std::vector<ast::ExprId>& generics, const CheckedArguments& arguments,
                                const ast::Expr& call, ir::TypeId wanted) {
    Context& c = body.context;
    std::vector<Candidate> fitting;
    for (ast::DeclId overload : overloads)
        if (auto candidate = try_overload(body, overload, owner, generics, arguments, call, wanted))
            fitting.push_back(std::move(*candidate));
    if (fitting.empty()) {
        Diagnostic& diagnostic = c.error(Diag::no_overload, call.span, {c.text(c[overloads[0]].name.name)});
        for (ast::DeclId overload : overloads) note(diagnostic, c[overload].name.span, "does not fit");
        return std::nullopt;
    }
    std::size_t best = 0;
    for (std::size_t i = 1; i < fitting.size(); ++i)
        if (is_better(c, fitting[i], fitting[best])) best = i;
    for (std::size_t i = 0; i < fitting.size(); ++i) {
        if (i == best || !is_ambiguous(body, fitting[i], fitting[best])) continue;
        Diagnostic& diagnostic = c.error(Diag::ambiguous_call, call.span, {c.text(c[overloads[0]].name.name)});
        for (const Candidate& candidate : fitting) note(diagnostic, c[candidate.decl].name.span, "fits");
        if (fitting[i].result != fitting[best].result)
            note(diagnostic, call.span,
                 "say which result is wanted, as in 'let x: " + c.text(fitting[best].result) + " = …'");
        return std::nullopt;
    }
    return std::move(fitting[best]);
}

/// Chooses among the overloads and finishes the call.
Operand resolve(Body& body, const std::vector<ast::DeclId>& overloads, const Env* owner,
                const std::vector<ast::ExprId>& generics, CheckedArguments& checked,
                const std::vector<ast::ExprId>& arguments, const ast::Expr& call, ir::TypeId wanted,
                const Operand* self) {
    if (overloads.size() == 1) {
        auto env = match(body, overloads[0], owner, generics, checked, call, wanted, false);
        if (!env) env = match(body, overloads[0], owner, generics, checked, call, {}, true);
        if (!env) return error_operand(call.span);
        return finish_call(body, overloads[0], *env, checked, arguments, call, self);
    }
    auto chosen = choose(body, overloads, owner, generics, checked, call, wanted);
    if (!chosen) return error_operand(call.span);
    return finish_call(body, chosen->decl, *chosen->env, checked, arguments, call, self);
}

std::vector<ir::TypeId> types_of(Body& body, const CheckedArguments& arguments) {
    std::vector<ir::TypeId> types;
    for (const Operand& operand : arguments.operands)
        if (ir::TypeId type = operand_type(body, operand)) types.push_back(type);
    return types;
}

}  // namespace

Operand call_function(Body& body, const std::vector<ast::DeclId>& overloads, const Env* owner,
                      const std::vector<ast::ExprId>& explicit_generics, const std::vector<ast::ExprId>& arguments,
                      const ast::Expr& call, ir::TypeId wanted, const Operand* self) {
    CheckedArguments checked = check_arguments(body, arguments);
    if (checked.failed) return error_operand(call.span);
    return resolve(body, overloads, owner, explicit_generics, checked, arguments, call, wanted, self);
}

std::optional<Operand> call_by_name(Body& body, ast::Identifier name, std::vector<ast::DeclId> visible,
                                    const std::vector<ast::ExprId>& explicit_generics, const ast::Expr& call,
                                    ir::TypeId wanted) {
    if (visible.empty() && !some_module_has_function(body.context, name.name)) return std::nullopt;
    std::vector<ast::ExprId> arguments(call.operands.begin() + 1, call.operands.end());
    CheckedArguments checked = check_arguments(body, arguments);
    if (checked.failed) return error_operand(call.span);
    add_functions_of_types(body.context, name.name, types_of(body, checked), visible);
    if (visible.empty()) return std::nullopt;
    return resolve(body, visible, nullptr, explicit_generics, checked, arguments, call, wanted, nullptr);
}

}  // namespace gliftc::sema
