// long: the checks of statements and expressions of pipelines call each other
// Checks the statements and expressions that only pipelines and tests have: temporaries, calls of kernels and
// pipelines, slices, values on the device, and `expect` and the like.
#include "ir/changes.h"
#include "sema/bodies/closures.h"
#include "sema/bodies/messages.h"
#include "sema/bodies/order.h"
#include "sema/kernels/aliasing.h"
#include "sema/names/record.h"
#include "sema/pipelines/pass_overloads.h"
#include "sema/pipelines/predication.h"
#include "sema/pipelines/values.h"
#include "sema/structures/components.h"
#include "sema/structures/constructors.h"
#include "sema/types/generics.h"
#include "sema/types/instances.h"
#include "sema/types/typing.h"

#include <algorithm>
#include <span>

namespace gliftc::sema {

namespace {

std::vector<ast::ExprId> arguments_of(const ast::Expr& call) {
    return {call.operands.begin() + 1, call.operands.end()};
}

/// The instance of an operand that is a structure, a slice of one, or a value of slice type; empty for any other
/// operand.
ir::StructureId structure_of(Body& body, const Operand& operand) {
    if (operand.kind == OperandKind::structure) return operand.structure;
    if (operand.kind == OperandKind::value && body.types().kind(operand.type) == ir::TypeKind::slice)
        return body.types()[body.types()[operand.type].element].structure;
    return {};
}

Operand operand_of_local(Body& body, ir::LocalId local, ir::TypeId type, Span span) {
    Operand structure;
    structure.kind = OperandKind::structure;
    structure.span = span;
    structure.local = local;
    structure.is_slice = body.types().kind(type) == ir::TypeKind::slice;
    structure.structure = body.types()[structure.is_slice ? body.types()[type].element : type].structure;
    structure.type = type;
    return structure;
}

void emit_temp(Body& body, ir::LocalId local, ir::Operands arguments, Span span) {
    settle(body, {arguments.begin(), arguments.end()});
    ir::StmtId id = add(body.program(), ir::StmtOp::temp, span);
    body.program().stmts[id].local = local;
    body.made.emplace(local, arguments);
    body.program().stmts[id].arguments = std::move(arguments);
    emit(body, id);
    require_transfers(body.context, body.types()[body.program().locals[local].type].structure, span);
}

}  // namespace

Operand declared(Body& body, const Operand& operand) {
    if (operand.kind != OperandKind::value || body.types().kind(operand.type) != ir::TypeKind::structure)
        return operand;
    const ir::Expr made = body.program().exprs[operand.expr];
    if (made.op != ir::Op::construct) return operand;
    ir::LocalId local = add_local(body.program(), body.context.names.intern("made"), made.type, operand.span);
    emit_temp(body, local, made.operands, operand.span);
    return operand_of_local(body, local, made.type, operand.span);
}

namespace {

struct Argument : PassArgument {
    Operand operand;
    Steps steps;
};

std::vector<Argument> check_arguments(Body& body, const ast::Expr& call, bool& failed) {
    std::vector<Argument> result;
    for (ast::ExprId id : arguments_of(call)) {
        Argument argument;
        argument.written = id;
        argument.waits = waits_for_parameter(body.context, id);
        if (!argument.waits) {
            const Recording recording(body, argument.steps);
            argument.operand = declared(body, check(body, id));
            // to_value() reports a memory, which no pass takes.
            if (argument.operand.kind == OperandKind::memory)
                argument.operand = value_operand(body, to_value(body, argument.operand), argument.operand.span);
            failed |= argument.operand.kind == OperandKind::error;
            argument.structure = structure_of(body, argument.operand);
            if (argument.operand.kind == OperandKind::value) {
                const ir::Type& type = body.types()[argument.operand.type];
                argument.type = type.kind == ir::TypeKind::device ? type.element : argument.operand.type;
            }
        }
        result.push_back(std::move(argument));
    }
    return result;
}

/// A value argument of a kernel or pipeline, which may lie on the host or on the device.
ir::ExprId value_argument(Body& body, const Argument& argument, ir::TypeId wanted) {
    const ir::ExprId value =
        argument.waits ? check_hinted(body, argument.written, wanted) : to_value(body, argument.operand);
    const bool fits = is_on_device(body, value) && body.types()[body.program().exprs[value].type].element == wanted;
    return fits ? value : coerce(body, value, wanted, body.context[argument.written].span);
}

/// The operand that calls of kernels, `expect` and the like give, which have no result.
Operand no_value(Body& body, Span span) {
    return value_operand(body, add(body.program(), ir::Op::constant, body.types().void_, span), span);
}

std::optional<ir::Operands> kernel_arguments(Body& body, ir::KernelId kernel_index, std::vector<Argument>& arguments) {
    Context& c = body.context;
    ir::Operands values;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const ir::KernelParam param = body.program().kernels[kernel_index].params[i];
        Span span = c[arguments[i].written].span;
        append(body, std::exchange(arguments[i].steps, {}));
        if (param.pattern == ir::Pattern::value) {
            values.push_back(value_argument(body, arguments[i], body.program().locals[param.local].type));
            // Values on the device that are not locals yet become locals here: elements are read and passes run in the
            // order in which the arguments are written, before the kernel.
            if (is_on_device(body, values.back()) && body.program().exprs[values.back()].op != ir::Op::local)
                values.back() =
                    make_local(body.program(), emit_temporary(body, c.text(param.name), values.back(), span), span);
        } else {
            if (!arguments[i].structure && !arguments[i].waits && !arguments[i].operand.type) {
                to_value(body, arguments[i].operand);  // reports what is no value
                return std::nullopt;
            }
            const ir::TypeId wanted = body.types().of_structure(param.structure);
            if (!arguments[i].waits && report_closure(c, arguments[i].operand.type, wanted, span)) return std::nullopt;
            if (!arguments[i].structure || arguments[i].structure != param.structure) {
                std::string have = arguments[i].structure ? body.program().structures[arguments[i].structure].display
                                   : arguments[i].waits   ? "a number"
                                                          : c.text(arguments[i].operand.type);
                note(c.error(Diag::type_mismatch, span, {body.program().structures[param.structure].display, have}),
                     param.span, "parameter '" + c.text(param.name) + "' is declared here");
                return std::nullopt;
            }
            values.push_back(to_value(body, arguments[i].operand));
        }
        if (is_error(body, values.back())) return std::nullopt;
    }
    return values;
}

/// Inserts the omitted argument of the `at` parameter: it is the argument of the parameter that gives the range.
void insert_address(const std::vector<ir::KernelParam>& params, std::size_t at, std::vector<Argument>& arguments) {
    auto giver = ir::range_giver(params, at);
    if (!giver) return;
    Argument address = arguments[*giver < at ? *giver : *giver - 1];
    address.steps = {};
    arguments.insert(arguments.begin() + static_cast<std::ptrdiff_t>(at), std::move(address));
}

void report_argument_count(Context& c, ast::DeclId id, std::size_t wanted, std::size_t found, Span call) {
    note(c.error(Diag::argument_count, call, {c.text(c[id].name.name), std::to_string(wanted), std::to_string(found)}),
         c[id].name.span, "declared here");
}

/// Whether another parameter of the kernel gives the range of `address`, a bare `at` whose argument the call leaves
/// out; reports if none does. True for an `at` that names its structure: insert_address() looks for its range.
bool is_range_given(Context& c, const Arguments& generics, const ast::Param& address, Span call) {
    const auto unnamed = generics.index_of(address.type);
    if (!unnamed || !generics.decl.generics[*unnamed].is_unnamed() || generics.decl.generics[*unnamed].default_value)
        return true;
    note(c.error(Diag::nothing_visited, call, {c.text(generics.decl.name.name)}), address.name.span,
         "pass a structure or a range of one for '" + c.text(address.name.name) + "'");
    return false;
}

std::optional<Operand> call_kernel(Body& body, ast::DeclId id, const std::vector<ast::ExprId>& explicit_generics,
                                   const ast::Expr& call, std::vector<Argument> arguments) {
    Context& c = body.context;
    const auto& written = std::get<ast::Kernel>(c[id].body);
    Env& env = c.new_env(c.module_of.at(id));
    Arguments generics(c, c[id], env, call.span);
    if (!generics.give(env_for(body, explicit_generics), explicit_generics)) return std::nullopt;
    std::optional<std::size_t> left_out;
    if (arguments.size() + 1 == written.params.size()) left_out = only_address(written.params);
    std::vector<ast::Param> given = written.params;
    if (left_out) given.erase(given.begin() + static_cast<std::ptrdiff_t>(*left_out));
    if (given.size() != arguments.size()) {
        report_argument_count(c, id, written.params.size(), arguments.size(), call.span);
        return std::nullopt;
    }
    if (left_out && !is_range_given(c, generics, written.params[*left_out], call.span)) return std::nullopt;
    infer_arguments(body, generics, given, {arguments.begin(), arguments.end()});
    if (!generics.finish()) return std::nullopt;
    auto kernel = instantiate_kernel(c, id, env, call.span);
    if (!kernel) return std::nullopt;
    const std::vector<ir::KernelParam> params = body.program().kernels[kernel].params;
    if (left_out) insert_address(params, *left_out, arguments);
    if (arguments.size() != params.size()) {
        report_argument_count(c, id, params.size(), arguments.size(), call.span);
        return std::nullopt;
    }
    auto values = kernel_arguments(body, kernel, arguments);
    if (!values) return std::nullopt;
    check_one_memory(body, body.program().kernels[kernel], *values);
    std::vector<bool> on_device;
    for (ir::ExprId value : *values) on_device.push_back(is_on_device(body, value));
    if (std::ranges::find(on_device, true) != on_device.end())
        kernel = kernel_with_arguments(c, kernel, on_device, call.span);
    ir::StmtId stmt = add(body.program(), ir::StmtOp::dispatch, call.span);
    body.program().stmts[stmt].slot = kernel.index;
    body.program().stmts[stmt].arguments = std::move(*values);
    emit(body, stmt);
    return no_value(body, call.span);
}

std::optional<ir::ExprId> pipeline_argument(Body& body, const Argument& argument, const ast::Param& param,
                                            const Env& env) {
    Context& c = body.context;
    const Span span = c[argument.written].span;
    if (param.pattern == ast::Pattern::range && !argument.structure) {
        c.error(Diag::range_wanted, span, {c.text(param.name.name)});
        return std::nullopt;
    }
    ir::ExprId value;
    if (param.pattern != ast::Pattern::none) {
        value = to_value(body, argument.operand);
    } else {
        const ir::TypeId wanted = type_of(c, env, param.type);
        if (body.types().kind(wanted) != ir::TypeKind::structure) value = value_argument(body, argument, wanted);
        else value = coerce(body, to_value(body, argument.operand), wanted, span);
    }
    if (is_error(body, value)) return std::nullopt;
    return value;
}

/// Whether the call would change a container that the calling pipeline declares `in`; reports it.
bool is_changing_constant(Body& body, ir::PipelineId called, const Operand* owner, const ir::Operands& values,
                          Span call) {
    const ir::Program& program = body.program();
    const ir::Pipeline& pipeline = program.pipelines[called];
    const auto is_constant = [&](ir::LocalId local) {
        return std::ranges::find(body.constants, local) != body.constants.end();
    };
    ir::LocalId changed;
    if (owner && pipeline.changes_owner && is_constant(owner->local)) changed = owner->local;
    for (std::size_t i = 0; i < values.size() && !changed; ++i) {
        const ir::Expr& value = program.exprs[values[i]];
        const bool is_given = value.op == ir::Op::structure_value && is_constant(value.local);
        if (is_given && ir::may_be_changed(program, pipeline.params[i])) changed = value.local;
    }
    if (!changed) return false;
    const ir::Local& container = program.locals[changed];
    note(body.context.error(Diag::constant_container, call,
                            {body.context.text(container.name), body.context.text(pipeline.name)}),
         container.span, "declare it 'inout'");
    return true;
}

std::optional<Operand> call_pipeline(Body& body, ast::DeclId id, const std::vector<ast::ExprId>& explicit_generics,
                                     const ast::Expr& call, const Operand* owner, std::vector<Argument> arguments) {
    Context& c = body.context;
    const auto& written = std::get<ast::Pipeline>(c[id].body);
    if (arguments.size() != written.params.size()) {
        report_argument_count(c, id, written.params.size(), arguments.size(), call.span);
        return std::nullopt;
    }
    Env& env = c.new_env(c.module_of.at(id));
    if (owner) env.bindings = c.structure_env.at(owner->structure)->bindings;
    Arguments generics(c, c[id], env, call.span);
    if (!generics.give(env_for(body, explicit_generics), explicit_generics)) return std::nullopt;
    infer_arguments(body, generics, written.params, {arguments.begin(), arguments.end()});
    if (!generics.finish()) return std::nullopt;
    std::vector<Passed> passed;
    ir::Operands values;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        append(body, std::move(arguments[i].steps));
        auto value = pipeline_argument(body, arguments[i], written.params[i], env);
        if (!value) return std::nullopt;
        const bool is_range = written.params[i].pattern == ast::Pattern::range;
        if (is_range) passed.push_back({.structure = arguments[i].structure});
        else passed.push_back({.on_device = is_on_device(body, *value)});
        values.push_back(*value);
    }
    const ir::PipelineId pipeline =
        instantiate_pipeline(c, id, env, passed, owner ? owner->structure : ir::StructureId{}, call.span);
    if (!pipeline) return std::nullopt;
    if (const Span at = body.program().pipelines[pipeline].host_needed) {
        const std::string what = "a call of '" + c.text(c[id].name.name) + "'";
        if (is_refused_in_arm(body, what, call.span, "call it outside of the condition: the host takes part in it"))
            return std::nullopt;
        needs_host(body, at);
    }
    if (is_changing_constant(body, pipeline, owner, values, call.span)) return std::nullopt;
    ir::ExprId result = add(body.program(), ir::Op::pipeline_call, body.program().pipelines[pipeline].result, call.span,
                            std::move(values));
    body.program().exprs[result].slot = pipeline.index;
    if (owner) body.program().exprs[result].place = owner->place, body.program().exprs[result].local = owner->local;
    add_effect(body, result);
    return value_operand(body, result, call.span);
}

ir::ExprId slice_of(Body& body, const Operand& structure, ir::ExprId low, ir::ExprId high, Span span) {
    ir::TypeId type = body.types().slice(body.types().of_structure(structure.structure));
    return structure_operation(body, ir::Op::slice, type, structure, span, {low, high});
}

Operand check_slice(Body& body, const Operand& structure, const ast::Expr& range, Span span) {
    Context& c = body.context;
    ir::TypeId domain = body.program().structures[structure.structure].domain_type;
    ir::ExprId low = check_value(body, range.operands[0], domain);
    ir::ExprId high = to_value(body, check(body, range.operands[1], domain));
    if (is_error(body, low) || is_error(body, high)) return error_operand(span);
    ir::TypeId high_type = body.program().exprs[high].type;
    bool on_device = body.types().kind(high_type) == ir::TypeKind::device;
    if (on_device && body.types()[high_type].element == domain) {
        auto known = known_value(body, low);
        const auto is_other = [](const ir::Lane& lane) { return lane.bits != 0; };
        if (!known || std::ranges::any_of(known->lanes, is_other)) {
            note(c.error(Diag::device_slice_origin, span), span,
                 "a slice with a length on the device begins at 0: a[0 .. n]");
            return error_operand(span);
        }
    } else {
        high = coerce(body, high, domain, c[range.operands[1]].span);
        if (is_error(body, high)) return error_operand(span);
    }
    return value_operand(body, slice_of(body, structure, low, high, span), span);
}

ir::ExprId make_count(Body& body, const Operand& structure, Span span) {
    return structure_operation(body, ir::Op::element_count, body.types().uint, structure, span);
}

ir::StmtId emit_expect(Body& body, ir::StmtOp op, ir::Operands arguments, Span span) {
    ir::StmtId stmt = add(body.program(), op, span);
    body.program().stmts[stmt].arguments = std::move(arguments);
    emit(body, stmt);
    return stmt;
}

/// The conditions that `condition` joins by `&&`, in order.
void add_joined(const Context& c, ast::ExprId condition, std::vector<ast::ExprId>& joined) {
    const ast::Expr& expr = c[condition];
    if (expr.kind != ast::ExprKind::binary || expr.binary != ast::BinaryOp::logical_and)
        return joined.push_back(condition);
    for (ast::ExprId side : expr.operands) add_joined(c, side, joined);
}

/// Whether a test can print values of the type.
bool is_shown(const ir::Types& types, ir::TypeId type) {
    return types.is_scalar(type) || types.is_vector(type) || types.kind(type) == ir::TypeKind::enum_;
}

/// If the condition compares two values that can be printed, puts these into locals, and returns them; `condition` then
/// compares the locals.
ir::Operands name_sides(Body& body, ir::ExprId& condition) {
    const ir::Expr compared = body.program().exprs[condition];
    const bool compares = compared.op == ir::Op::binary && compared.binary >= ir::BinaryOp::less &&
                          compared.binary <= ir::BinaryOp::not_equal;
    if (!compares || !is_shown(body.types(), body.program().exprs[compared.operands[0]].type)) return {};
    ir::Operands sides;
    for (ir::ExprId side : compared.operands) {
        const Span span = body.program().exprs[side].span;
        sides.push_back(make_local(body.program(), emit_temporary(body, "side", side, span), span));
    }
    condition = make_binary(body.program(), compared.binary, compared.type, sides[0], sides[1], compared.span);
    return sides;
}

/// Expects the conditions one by one, so that the message says which one is false. Each is evaluated only if those
/// before it are true. False: one has an error.
bool expect_each(Body& body, std::span<const ast::ExprId> conditions) {
    const Span span = body.context[conditions[0]].span;
    ir::ExprId condition = check_value(body, conditions[0], body.types().bool_);
    if (is_error(body, condition)) return false;
    ir::Operands sides = name_sides(body, condition);
    if (conditions.size() == 1) {
        body.program().stmts[emit_expect(body, ir::StmtOp::expect, std::move(sides), span)].value = condition;
        return true;
    }
    const bool compares_locals = !sides.empty();
    const ir::LocalId holds = emit_temporary(body, "holds", condition, span);
    if (!compares_locals) condition = make_local(body.program(), holds, span);
    const ir::StmtId expected = emit_expect(body, ir::StmtOp::expect, std::move(sides), span);
    body.program().stmts[expected].value = condition;
    std::vector<ir::StmtId> rest;
    auto* outer = std::exchange(body.block, &rest);
    const bool fine = expect_each(body, conditions.subspan(1));
    body.block = outer;
    const ir::StmtId branch = add(body.program(), ir::StmtOp::if_, span);
    body.program().stmts[branch].value = make_local(body.program(), holds, span);
    body.program().stmts[branch].body = std::move(rest);
    emit(body, branch);
    return fine;
}

Operand check_expect_true(Body& body, const std::vector<ast::ExprId>& arguments, const ast::Expr& call) {
    std::vector<ast::ExprId> conditions;
    add_joined(body.context, arguments[0], conditions);
    return expect_each(body, conditions) ? no_value(body, call.span) : error_operand(call.span);
}

Operand check_expect_near(Body& body, const std::vector<ast::ExprId>& arguments, const ast::Expr& call) {
    const bool is_swapped = is_flexible(body.context, arguments[0]);
    Alternative first = recorded(body, [&] { return check_value(body, arguments[is_swapped ? 1 : 0]); });
    ir::ExprId a = first.value;
    ir::TypeId type = body.program().exprs[a].type;
    if (!is_swapped) append(body, std::exchange(first.steps, {}));
    ir::ExprId b = check_value(body, arguments[is_swapped ? 0 : 1], type);
    append(body, std::move(first.steps));
    if (is_error(body, a) || is_error(body, b)) return error_operand(call.span);
    ir::ExprId tolerance = check_value(body, arguments[2], body.types().scalar_of(type));
    if (is_error(body, tolerance)) return error_operand(call.span);
    emit_expect(body, ir::StmtOp::expect_near, {a, b, tolerance}, call.span);
    return no_value(body, call.span);
}

Operand check_expect_same(Body& body, const std::vector<ast::ExprId>& arguments, const ast::Expr& call) {
    Context& c = body.context;
    ir::Operands values;
    std::vector<ir::StructureId> structures;
    for (std::size_t i = 0; i < 2; ++i) {
        Operand operand = declared(body, check(body, arguments[i]));
        auto structure = structure_of(body, operand);
        if (operand.kind == OperandKind::error) return operand;
        if (!structure || body.program().structures[structure].kind != ir::StructureKind::stored) {
            Diagnostic& diagnostic = c.error(Diag::structure_wanted, c[arguments[i]].span, {"expect_same"});
            if (structure && body.program().structures[structure].kind == ir::StructureKind::computed)
                note(diagnostic, c[arguments[i]].span, "a view has no elements in memory: copy it into a structure");
            return error_operand(call.span);
        }
        require_transfers(c, structure, call.span);
        structures.push_back(structure);
        values.push_back(to_value(body, operand));
    }
    const ir::Structure &a = body.program().structures[structures[0]], &b = body.program().structures[structures[1]];
    if (a.element != b.element || a.domain_type != b.domain_type) {
        c.error(Diag::type_mismatch, c[arguments[1]].span, {a.display, b.display});
        return error_operand(call.span);
    }
    if (arguments.size() == 3) values.push_back(check_value(body, arguments[2], body.types().float_));
    emit_expect(body, ir::StmtOp::expect_same, std::move(values), call.span);
    return no_value(body, call.span);
}

std::optional<Operand> check_expect(Body& body, std::string_view name, const ast::Expr& call) {
    Context& c = body.context;
    std::vector<ast::ExprId> arguments = arguments_of(call);
    bool same = name == "expect_same", near = name == "expect_near";
    std::size_t least = same ? 2 : near ? 3 : 1, most = same ? 3 : least;
    if (!body.in_test) {
        c.error(Diag::expect_outside_test, call.span, {name});
        return error_operand(call.span);
    }
    if (is_refused_in_arm(body, "'" + std::string(name) + "'", call.span, "check what is left after the condition"))
        return error_operand(call.span);
    if (arguments.size() < least || arguments.size() > most) {
        const std::string wanted = std::to_string(least) + (most > least ? " or " + std::to_string(most) : "");
        c.error(Diag::argument_count, call.span, {name, wanted, std::to_string(arguments.size())});
        return error_operand(call.span);
    }
    return same   ? check_expect_same(body, arguments, call)
           : near ? check_expect_near(body, arguments, call)
                  : check_expect_true(body, arguments, call);
}

/// Checks `temp name = Structure(arguments);`, or a `let` or `var` without a written type whose value is a call or a
/// slice, such as `let part = a[0..n];`. Always true, which tells callers that the statement has been checked.
bool check_structure_declaration(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    bool is_temp = stmt.kind == ast::StmtKind::temp;
    Operand operand = check(body, stmt.value);
    if (operand.kind == OperandKind::error) {
        Symbol broken;
        broken.kind = SymbolKind::local;
        broken.type = body.types().error;
        broken.local = add_local(body.program(), stmt.name.name, body.types().error, stmt.name.span);
        declare(body, stmt.name, broken);
        return true;
    }
    ir::ExprId value = to_value(body, operand);
    if (is_error(body, value)) return true;
    const ir::Expr node = body.program().exprs[value];
    if (node.type == body.types().void_) {
        c.error(Diag::void_value, c[stmt.value].span);
        declare_local(body, stmt.name, body.types().error, false, false);
        return true;
    }
    bool made = node.op == ir::Op::construct && body.types().kind(node.type) == ir::TypeKind::structure;
    if (is_temp && !made) {
        note(c.error(Diag::temp_value, c[stmt.value].span), c[stmt.value].span,
             "'temp' makes a structure: temp name = Structure(arguments); for values write 'let'");
        return true;
    }
    if (stmt.is_uninitialized &&
        body.program().structures[body.types()[node.type].structure].kind == ir::StructureKind::computed)
        c.error(Diag::uninitialized_view, c[stmt.value].span, {c.text(node.type)});
    const bool is_mutable = stmt.binding == ast::Binding::var;
    if (!made) value = as_declared(body, value, stmt.name.span);
    ir::LocalId local = declare_local(body, stmt.name, body.program().exprs[value].type, is_mutable);
    if (is_mutable) declare_variable(body, local);
    if (!made && !is_mutable) body.lets[local] = value;
    if (made) {
        emit_temp(body, local, node.operands, stmt.span);
        body.program().stmts[body.block->back()].uninitialized = stmt.is_uninitialized;
        return true;
    }
    ir::StmtId id = add(body.program(), ir::StmtOp::let, stmt.span);
    body.program().stmts[id].local = local;
    body.program().stmts[id].value = value;
    emit(body, id);
    return true;
}

bool is_structure_value(Body& body, ast::ExprId id) {
    const Context& c = body.context;
    const ast::Expr& expr = c[id];
    return expr.kind == ast::ExprKind::call || (expr.kind == ast::ExprKind::index && expr.operands.size() == 2 &&
                                                c[expr.operands[1]].kind == ast::ExprKind::range);
}

}  // namespace

std::optional<Operand> as_structure(Body& body, const Operand& operand) {
    Operand structure = declared(body, operand);
    if (structure.kind == OperandKind::structure) return structure;
    if (structure.kind != OperandKind::value || body.types().kind(structure.type) != ir::TypeKind::slice)
        return std::nullopt;
    ir::LocalId local = emit_temporary(body, "part", structure.expr, structure.span);
    return operand_of_local(body, local, structure.type, structure.span);
}

Operand construct_structure(Body& body, ir::TypeId type, const ast::Expr& call) {
    Context& c = body.context;
    if (body.kind != BodyKind::pipeline) {
        note(c.error(Diag::structure_made_here, call.span, {c.text(type)}), call.span,
             "structures are made by 'temp' in a pipeline, by 'structure' in another structure, or in C++");
        return error_operand(call.span);
    }
    const ir::StructureId index = body.types()[type].structure;
    ast::DeclId decl = c.structure_decl.at(index);
    const std::vector<ast::Param>* params = constructor_of(c[decl]);
    std::vector<ast::ExprId> written = arguments_of(call);
    if (!has_argument_count(c, index, call)) return error_operand(call.span);
    ir::Operands operands;
    std::vector<ir::ExprId> values;
    for (std::size_t i = 0; i < written.size(); ++i) {
        ir::TypeId wanted = type_of(c, *c.structure_env.at(index), (*params)[i].type);
        Operand value = declared(body, check(body, written[i], wanted));
        operands.push_back(coerce(body, to_value(body, value), wanted, c[written[i]].span));
        if (is_error(body, operands.back())) return error_operand(call.span);
        if (body.types().kind(wanted) != ir::TypeKind::structure) values.push_back(operands.back());
    }
    for (ir::ExprId omitted : omitted_arguments(body, index, std::move(values))) operands.push_back(omitted);
    return value_operand(body, add(body.program(), ir::Op::construct, type, call.span, std::move(operands)), call.span);
}

Operand check_pipeline_index(Body& body, const Operand& structure, const ast::Expr& expr) {
    Context& c = body.context;
    const ir::Structure instance = body.program().structures[structure.structure];
    if (instance.kind == ir::StructureKind::no_elements) {
        c.error(Diag::not_indexable, expr.span, {instance.display});
        return error_operand(expr.span);
    }
    const ast::Expr& index = c[expr.operands[1]];
    if (index.kind == ast::ExprKind::range) return check_slice(body, structure, index, expr.span);
    ir::ExprId address = check_value(body, expr.operands[1], instance.domain_type);
    if (is_error(body, address)) return error_operand(expr.span);
    if (instance.kind == ir::StructureKind::computed) {
        c.error(Diag::view_read_on_host, expr.span, {instance.display});
        return error_operand(expr.span);
    }
    require_transfers(c, structure.structure, expr.span);
    return value_operand(body,
                         structure_operation(body, ir::Op::device_read, body.types().device(instance.element),
                                             structure, expr.span, {address}),
                         expr.span);
}

std::optional<Operand> check_pipeline_call(Body& body, const std::vector<ast::DeclId>& decls,
                                           const std::vector<ast::ExprId>& generics, const ast::Expr& call,
                                           const Operand* owner) {
    Context& c = body.context;
    if (body.kind != BodyKind::pipeline) {
        c.error(Diag::pass_outside_pipeline, call.span, {c.text(c[decls[0]].name.name)});
        return std::nullopt;
    }
    bool failed = false;
    const std::vector<Argument> arguments = check_arguments(body, call, failed);
    if (failed) return std::nullopt;
    const auto chosen = choose_pass(body, decls, generics, {arguments.begin(), arguments.end()}, call, owner);
    if (!chosen) return std::nullopt;
    record_choice(c, call, *chosen);
    if (std::holds_alternative<ast::Kernel>(c[*chosen].body))
        return call_kernel(body, *chosen, generics, call, arguments);
    return call_pipeline(body, *chosen, generics, call, owner, arguments);
}

std::optional<Operand> check_pipeline_builtin(Body& body, std::string_view name, const ast::Expr& call) {
    Context& c = body.context;
    if (name == "expect" || name == "expect_near" || name == "expect_same") return check_expect(body, name, call);
    if (name != "count") return std::nullopt;
    std::vector<ast::ExprId> arguments = arguments_of(call);
    if (arguments.size() != 1) {
        c.error(Diag::argument_count, call.span, {name, "1", std::to_string(arguments.size())});
        return error_operand(call.span);
    }
    Operand operand = declared(body, check(body, arguments[0]));
    if (operand.kind == OperandKind::error) return operand;
    if (!structure_of(body, operand)) {
        c.error(Diag::structure_wanted, c[arguments[0]].span, {name});
        return error_operand(call.span);
    }
    return value_operand(body, make_count(body, *as_structure(body, operand), call.span), call.span);
}

bool check_pipeline_statement(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    switch (stmt.kind) {
    case ast::StmtKind::temp: return check_structure_declaration(body, stmt);
    case ast::StmtKind::let:
        // Only `let` and `var` of a call, which may give a structure, or of a slice, with no type after the name. Any
        // other declaration is checked as in functions.
        if (stmt.type || !stmt.value || stmt.binding == ast::Binding::const_ || !is_structure_value(body, stmt.value))
            return false;
        return check_structure_declaration(body, stmt);
    case ast::StmtKind::expression: {
        const ast::Expr& call = c[stmt.value];
        if (call.kind != ast::ExprKind::call || is_message(body, call)) return false;
        Operand operand = check(body, stmt.value);
        if (operand.kind == OperandKind::value) {
            const ir::Expr& node = body.program().exprs[operand.expr];
            if (node.op == ir::Op::constant && node.type == body.types().void_)
                return true;  // a call of a kernel, or an expect: emitted already
            if (node.op != ir::Op::call && node.op != ir::Op::pipeline_call) c.error(Diag::no_effect, call.span);
            ir::StmtId id = add(body.program(), ir::StmtOp::evaluate, stmt.span);
            body.program().stmts[id].value = operand.expr;
            emit(body, id);
        }
        return true;
    }
    default: return false;
    }
}

}  // namespace gliftc::sema
