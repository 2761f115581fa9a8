// Which function a call means, and the call itself: overloads, their generic arguments, their arguments.
#include "sema/bodies/closures.h"
#include "sema/bodies/messages.h"
#include "sema/bodies/order.h"
#include "sema/kernels/writing.h"
#include "sema/names/lookup.h"
#include "sema/names/record.h"
#include "sema/pipelines/values.h"
#include "sema/structures/components.h"
#include "sema/types/generics.h"
#include "sema/types/instances.h"
#include "sema/types/specificity.h"
#include "sema/types/typing.h"

namespace gliftc::sema {

namespace {

/// A viable overload, and the properties by which is_better() ranks it.
struct Candidate {
    ast::DeclId decl;
    std::unique_ptr<Env> env;
    ir::TypeId result;
    bool gives_wanted = true;
    bool is_generic = false;
    bool takes_as_they_are = true;  ///< no argument is wrapped into an optional
    bool takes_literals = true;     ///< literals keep their default types
};

struct CheckedArguments {
    std::vector<Operand> operands;  ///< of kind error, without a span, where `waits` is set
    std::vector<bool> waits;        ///< for each argument: it is checked only once its parameter's type is known
    std::vector<Steps> steps;
    bool failed = false;
};

ir::TypeId operand_type(Body& body, const Operand& operand) {
    if (operand.kind == OperandKind::value) return operand.type;
    if (operand.kind == OperandKind::structure) return body.types().of_structure(operand.structure);
    return {};
}

CheckedArguments check_arguments(Body& body, const std::vector<ast::ExprId>& arguments) {
    CheckedArguments result;
    const Parts parts(body);
    for (ast::ExprId argument : arguments) {
        bool waits = waits_for_parameter(body.context, argument);
        const Recording recording(body, result.steps.emplace_back());
        Operand operand;
        if (!waits) {
            operand = check(body, argument);
            if (body.kind == BodyKind::pipeline) operand = declared(body, operand);
            if (operand.kind == OperandKind::iterator) {
                const ir::KernelParam& param = body.kernel->params[operand.slot];
                if (param.pattern != ir::Pattern::near)
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

/// Whether an argument made of literals without suffix can take a parameter's type; true for other arguments.
bool takes_literal(Context& c, ast::ExprId argument, ir::TypeId parameter) {
    if (!is_flexible(c, argument) || parameter == c.types().error) return true;
    const ir::TypeId taken = operand_hint(c.types(), parameter), own = operand_hint(c.types(), own_type(c, argument));
    if (own == c.types().float_) return c.types().is_scalar(taken) && c.types().is_floating(taken);
    return c.types().is_scalar(taken) && c.types().is_number(taken);
}

/// Binds the generics of an overload; null if it is not viable. With `report`, reports why; errors within explicit
/// generic arguments are reported in any case.
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
    if (!explicit_generics.empty() && !generics.give(env_for(body, explicit_generics), explicit_generics, 0, !report))
        return nullptr;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        if (arguments.waits[i]) continue;
        if (arguments.operands[i].kind == OperandKind::structure)
            generics.infer_structure(function.params[i].type, arguments.operands[i].structure);
        else if (ir::TypeId type = operand_type(body, arguments.operands[i]))
            generics.infer(function.params[i].type, type);
        generics.locate(function.params[i].type, call.operands[i + 1]);
    }
    if (wanted && function.result) generics.infer(function.result, wanted);
    for (std::size_t i = 0; i < function.group.size() && i < 3 && body.grouped(); ++i)
        generics.infer_value(function.group[i], {body.types().uint, {ir::Lane{.bits = body.group[i]}}});
    for (std::size_t i = 0; i < function.params.size(); ++i)
        if (arguments.waits[i]) infer_from_literal(generics, function.params[i].type, call.operands[i + 1]);
    if (!generics.finish(!report)) return nullptr;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        if (!arguments.waits[i] && arguments.operands[i].kind == OperandKind::error) continue;
        ir::TypeId parameter = type_of(c, *env, function.params[i].type);
        if (arguments.waits[i]) {
            if (!report && !takes_literal(c, call.operands[i + 1], parameter)) return nullptr;
            continue;
        }
        ir::TypeId actual = operand_type(body, arguments.operands[i]);
        if (parameter == body.types().error || (actual && becomes(body.types(), actual, parameter))) continue;
        if (!report) return nullptr;
        if (!actual) to_value(body, arguments.operands[i]);  // reports that it is not a value
        else if (!report_closure(c, actual, parameter, arguments.operands[i].span)) {
            Diagnostic& diagnostic =
                c.error(Diag::type_mismatch, arguments.operands[i].span, {c.text(parameter), c.text(actual)});
            note(diagnostic, function.params[i].name.span,
                 "parameter '" + c.text(function.params[i].name.name) + "' is declared here");
        }
        return nullptr;
    }
    return env;
}

/// Whether the window of a function's `near` parameter is no larger than that of the argument; reports a larger one.
bool fits_window(Body& body, const Env& env, const ast::Param& param, const Operand& argument) {
    if (param.pattern != ast::Pattern::near) return true;
    Context& c = body.context;
    const ir::TypeId domain = c.program.structures[argument.structure].domain_type;
    const ir::Radius radius = window_radius(c, env, param, domain);
    if (argument.window.covers(radius)) return true;
    const std::string wanted = ir::to_text(radius, c.types().components(domain));
    note(c.error(Diag::window, argument.span, {c.text(param.name.name), wanted}), param.name.span,
         "pass a parameter that the kernel declares as near<…, " + wanted + ">");
    return false;
}

/// Whether the caller has the workgroup size that the function declares, if it declares one; reports if not.
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

/// Whether a call in a pipeline needs a pass of its own. A call that takes no structure does not: it stays part of its
/// expression, for which there is a pass if a value in it lies on the device (sema/pipelines/values.h). The host
/// evaluates a call that takes one whole structure and reads no elements, if it knows all values.
bool is_pass(Body& body, ir::FunctionId function, const std::vector<Operand>& structures, const ir::Operands& values) {
    if (body.kind != BodyKind::pipeline || structures.empty()) return false;
    if (std::ranges::any_of(values, [&](ir::ExprId value) { return is_open(body, value); })) return true;
    return structures.size() > 1 || structures[0].is_slice || body.program().functions[function].reads_memory;
}

/// Whether a pass can call the function; reports if not.
bool is_passable(Body& body, const ir::Function& function, Span span) {
    Context& c = body.context;
    const std::optional<ir::TypeId> refused = type_not_for_passes(c.program, function);
    if (!refused) return true;
    if (*refused == c.types().void_)
        note(c.error(Diag::void_value, span), span,
             "a call that gives nothing and writes nothing does nothing here: remove it, or call it in a kernel");
    else
        note(c.error(Diag::device_value_type, span, {c.text(*refused)}), span,
             std::string("it is the type of ") + (*refused == function.result ? "the result" : "a parameter") +
                 ": a pass evaluates this call, and memory holds neither optionals nor structs without fields; use a "
                 "struct of 'present: bool;' and the value");
    return false;
}

Operand call_as_pass(Body& body, ir::FunctionId function, const std::vector<Operand>& structures,
                     const ir::Operands& values, Span span) {
    if (!is_passable(body, body.program().functions[function], span)) return error_operand(span);
    ir::Operands arguments;
    std::vector<bool> on_device;
    for (ir::ExprId value : values) on_device.push_back(is_open(body, value));
    auto pipeline = pipeline_of_function(body.context, function, span, on_device);
    if (!pipeline) return error_operand(span);
    for (const Operand& structure : structures) arguments.push_back(to_value(body, structure));
    for (ir::ExprId value : values) arguments.push_back(closed(body, value));
    ir::ExprId result = add(body.program(), ir::Op::pipeline_call, body.program().pipelines[pipeline].result, span,
                            std::move(arguments));
    body.program().exprs[result].slot = pipeline.index;
    add_read(body, result);
    return value_operand(body, result, span);
}

/// The node of a call, or where is_pass() says so, a call of a pipeline that evaluates it in a pass (call_as_pass).
Operand call_instance(Body& body, ir::FunctionId function, const std::vector<Operand>& structures, ir::Operands values,
                      Span span) {
    if (is_pass(body, function, structures, values)) return call_as_pass(body, function, structures, values, span);
    ir::ExprId result =
        add(body.program(), ir::Op::call, body.program().functions[function].result, span, std::move(values));
    body.program().exprs[result].function = function;
    for (const Operand& operand : structures) body.program().exprs[result].places.push_back(operand.place);
    if (!structures.empty()) body.program().exprs[result].local = structures[0].local;
    const auto may_change = [&](const Operand& structure) {
        return body.kind == BodyKind::pipeline || !structure.writing.is(ir::Pattern::any);
    };
    if (body.program().functions[function].is_statements()) add_effect(body, result);
    else if (std::ranges::any_of(structures, may_change)) add_read(body, result);
    return value_operand(body, result, span);
}

/// Finishes a call of a matched function: checks the arguments that waited for parameter types, and makes the call
/// node.
Operand finish_call(Body& body, ast::DeclId id, const Env& env, CheckedArguments& arguments,
                    const std::vector<ast::ExprId>& written, const ast::Expr& call, const Operand* self) {
    Context& c = body.context;
    record_choice(c, call, id);
    const auto& function = std::get<ast::Function>(c[id].body);
    const Parts parts(body);
    ir::Operands values;
    std::vector<ir::StructureId> structures;
    std::vector<Operand> given;
    if (self) {
        structures.push_back(self->structure);
        given.push_back(*self);
    }
    for (std::size_t i = 0; i < written.size(); ++i) {
        Operand& operand = arguments.operands[i];
        append(body, std::move(arguments.steps[i]));
        if (operand.kind == OperandKind::structure) {
            if (!fits_window(body, env, function.params[i], operand)) return error_operand(call.span);
            if (!fits_writing(body, env, function.params[i], operand)) return error_operand(call.span);
            structures.push_back(operand.structure);
            given.push_back(operand);
            continue;
        }
        ir::TypeId parameter = type_of(c, env, function.params[i].type);
        values.push_back(arguments.waits[i] ? check_value(body, written[i], parameter)
                                            : coerce(body, to_value(body, operand), parameter, operand.span));
        if (is_error(body, values.back())) return error_operand(call.span);
    }
    if (!fits_group(body, id, env, call)) return error_operand(call.span);
    auto instance = instantiate_function(c, id, env, structures, call.span);
    if (!instance || !add_effects(body, *instance, given, self != nullptr, call.span)) return error_operand(call.span);
    if (!add_messages(body, *instance, call.span)) return error_operand(call.span);
    return call_instance(body, *instance, given, std::move(values), call.span);
}

/// Whether a function's result has the expected type, or that type is an optional of it; true if no type is expected.
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
        ast::ExprId literal = call.operands[i + 1];
        if (!arguments.waits[i] && given)
            candidate.takes_as_they_are &= given == type_of(c, *env, function.params[i].type);
        else if (is_flexible(c, literal))
            candidate.takes_as_they_are &=
                c.types().kind(type_of(c, *env, function.params[i].type)) != ir::TypeKind::optional;
        if (!is_flexible(c, literal)) continue;
        const ir::TypeId own = operand_hint(c.types(), own_type(c, literal));
        candidate.takes_literals &= own == operand_hint(c.types(), type_of(c, *env, function.params[i].type));
    }
    ast::ExprId result = function.result;
    ir::TypeId type = result ? type_of(c, *env, result) : c.types().void_;
    candidate.env = std::move(env);
    candidate.result = type;
    candidate.gives_wanted = gives(body, type, wanted);
    candidate.is_generic = !c[id].generics.empty();
    return candidate;
}

/// The order of docs/reference/language.md, "Overload resolution": expected result, no optionals made of arguments,
/// more specialised parameters, not generic, default types of literals.
bool is_better(const Context& c, const Candidate& a, const Candidate& b) {
    if (a.gives_wanted != b.gives_wanted) return a.gives_wanted;
    if (a.takes_as_they_are != b.takes_as_they_are) return a.takes_as_they_are;
    if (is_more_special(c, c[a.decl], c[b.decl])) return true;
    if (is_more_special(c, c[b.decl], c[a.decl])) return false;
    if (a.is_generic != b.is_generic) return !a.is_generic;
    return a.takes_literals && !b.takes_literals;
}

/// Whether two candidates rank equally and take the same types.
bool is_ambiguous(Body& body, const Candidate& a, const Candidate& b) {
    if (is_better(body.context, a, b) || is_better(body.context, b, a)) return false;
    Context& c = body.context;
    const auto& left = std::get<ast::Function>(c[a.decl].body).params;
    const auto& right = std::get<ast::Function>(c[b.decl].body).params;
    for (std::size_t i = 0; i < left.size(); ++i)
        if (type_of(c, *a.env, left[i].type) != type_of(c, *b.env, right[i].type)) return false;
    return true;
}

/// The best candidate, the first of equally good ones; reports if there is none, or the call is ambiguous.
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
        for (ast::DeclId overload : overloads) note(diagnostic, c[overload].name.span, "does not take these arguments");
        const auto is_closure = [&](const Operand& argument) { return closure_of(c, operand_type(body, argument)); };
        if (std::ranges::any_of(arguments.operands, is_closure))
            note(diagnostic, call.span,
                 "a closure is called as the interface of its parameter says: write the constraint, as 'F: "
                 "Function<float, float>'");
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

/// Selects an overload and finishes the call.
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

Operand call_of(Body& body, ir::FunctionId function, const Operand& self, ir::Operands values, Span span) {
    const Parts parts(body);
    return call_instance(body, function, {self}, std::move(values), span);
}

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
