#include "ir/empty.h"
#include "sema/bodies/messages.h"
#include "sema/bodies/order.h"
#include "sema/kernels/raster.h"
#include "sema/pipelines/predication.h"
#include "sema/pipelines/values.h"
#include "sema/structures/replace.h"
#include "sema/types/typing.h"

namespace gliftc::sema {

namespace {

constexpr unsigned nesting_limit = 200;

void check_let(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    ir::TypeId wanted = stmt.type ? type_of(c, env_for(body, stmt.type), stmt.type) : ir::TypeId{};
    ir::ExprId value;
    if (stmt.value) {
        Operand operand = check(body, stmt.value, wanted);
        value = to_value(body, operand);
        const bool is_device_type = is_on_device(body, value) && body.types()[operand.type].element == wanted;
        if (wanted && !is_device_type) value = coerce(body, value, wanted, c[stmt.value].span);
    } else if (lies_on_device_later(body, stmt.name.span)) {
        value = ir::zero(body.program(), wanted, stmt.name.span);
    }
    if (value) value = as_declared(body, value, stmt.name.span);
    ir::TypeId type = value && (is_on_device(body, value) || !wanted) ? body.program().exprs[value].type
                      : wanted                                        ? wanted
                                                                      : body.types().error;
    if (type == body.types().void_) {
        c.error(Diag::void_value, c[stmt.value].span);
        type = body.types().error;
    }
    if (stmt.binding == ast::Binding::const_ && value && !is_error(body, value)) {
        auto known = known_value(body, value);
        if (!known) c.error(Diag::not_constant, c[stmt.value].span);
        else value = ir::materialize(body.program(), *known, c[stmt.value].span);
    }
    bool is_mutable = stmt.binding == ast::Binding::var;
    ir::LocalId local = declare_local(body, stmt.name, type, is_mutable);
    if (!is_mutable && value) body.lets[local] = value;
    if (is_mutable && body.kind == BodyKind::pipeline) declare_variable(body, local);
    ir::StmtId let = add(body.program(), ir::StmtOp::let, stmt.span);
    body.program().stmts[let].local = local;
    body.program().stmts[let].value = value;
    emit(body, let);
}

void check_shared(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    ir::TypeId type = type_of(c, env_for(body, stmt.type), stmt.type);
    ir::LocalId local = declare_local(body, stmt.name, type, true);
    body.program().locals[local].storage = ir::Storage::shared;
    if (ir::holds_empty(body.program(), type)) {
        note(c.error(Diag::memory_element, c[stmt.type].span), c[stmt.type].span,
             "memory cannot hold a struct without fields");
        return;
    }
    if (!body.grouped()) {
        note(c.error(Diag::needs_group, stmt.span, {"shared"}), stmt.span,
             "write 'group(size)' after the kernel's parameters");
        return;
    }
    body.shared->push_back(local);
}

/// The expression at the start of an assignment's target: of the target `a.b[i].x`, `a`.
const ir::Expr* root_of(const Body& body, ir::ExprId target) {
    const ir::Expr* expr = &body.context.program.exprs[target];
    while (expr->op == ir::Op::index || expr->op == ir::Op::field || expr->op == ir::Op::swizzle)
        expr = &body.context.program.exprs[expr->operands[0]];
    return expr;
}

bool repeats_lane(const ir::Expr& swizzle, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t k = i + 1; k < count; ++k)
            if (swizzle.lanes[i] == swizzle.lanes[k]) return true;
    return false;
}

/// Assigns to the container's host state, in a pipeline of its own.
void assign_host_state(Body& body, const ast::Stmt& stmt, ir::ExprId target, std::uint32_t slot) {
    if (is_refused_in_arm(body, "a change of host state", stmt.span,
                          "keep what depends on the device there: in an element, or a 'var' of the pipeline"))
        return;
    needs_host(body, stmt.span);
    ir::ExprId value =
        stmt.op ? check_compound(body, stmt, target) : check_value(body, stmt.value, body.program().exprs[target].type);
    ir::StmtId assign = add(body.program(), ir::StmtOp::host_assign, stmt.span);
    body.program().stmts[assign].slot = slot;
    body.program().stmts[assign].target = target;
    body.program().stmts[assign].value = value;
    emit(body, assign);
}

void check_assign(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    if ((body.kernel || body.effects) && check_iterator_assignment(body, stmt)) return;
    if (check_replace(body, stmt)) return;
    ir::ExprId target = check_value(body, stmt.target);
    if (is_error(body, target)) {
        check_value(body, stmt.value);
        return;
    }
    is_target(body, target);
    const ir::Expr* root = root_of(body, target);
    if (body.kind == BodyKind::pipeline && root->op == ir::Op::host_state && root->place.members.empty() &&
        !root->local)
        return assign_host_state(body, stmt, target, root->slot);
    bool is_local = root->op == ir::Op::local;
    if (!is_local || !body.program().locals[root->local].is_mutable) {
        Diagnostic& diagnostic = c.error(Diag::not_assignable, c[stmt.target].span);
        if (is_local && std::ranges::find(body.captured, root->local) != body.captured.end())
            note(diagnostic, c[stmt.target].span,
                 "a closure captures values, which do not change: copy it, as in 'var copy = " +
                     c.text(body.program().locals[root->local].name) + ";', and change the copy");
        else if (is_local)
            note(diagnostic, body.program().locals[root->local].span, "declare it with 'var' to change it");
        return;
    }
    if (body.kind == BodyKind::pipeline && body.program().exprs[target].op == ir::Op::local)
        return check_variable(body, stmt, target);
    // The host executes the statements of an arm whether or not its condition is true. An assignment to a whole
    // variable becomes a `select`, which keeps the old value if the arm does not run (check_variable). An assignment to
    // a part of a variable does not, so the variable must be declared in the innermost arm.
    if (body.kind == BodyKind::pipeline && !is_of_innermost_arm(body, root->local) &&
        is_refused_in_arm(body, "a change of a part of a variable", stmt.span, "assign the whole variable"))
        return;
    const ir::Expr& node = body.program().exprs[target];
    if (node.op == ir::Op::swizzle && repeats_lane(node, body.types().components(node.type))) {
        c.error(Diag::repeated_component, c[stmt.target].span);
        return;
    }
    ir::TypeId type = node.type;
    ir::ExprId value;
    if (stmt.op) {
        value = check_compound(body, stmt, target);
        if (is_error(body, value)) return;
    } else {
        value = check_value(body, stmt.value, type);
    }
    ir::StmtId assign = add(body.program(), ir::StmtOp::assign, stmt.span);
    body.program().stmts[assign].target = target;
    body.program().stmts[assign].value = value;
    emit(body, assign);
}

void check_if_let(Body& body, const ast::Stmt& stmt) {
    ir::ExprId optional = check_value(body, stmt.value);
    ir::TypeId type = body.program().exprs[optional].type;
    if (!is_error(body, optional) && body.types().kind(type) != ir::TypeKind::optional) {
        body.context.error(Diag::not_optional, body.context[stmt.value].span, {body.context.text(type)});
        optional = error_value(body, stmt.span);
        type = body.types().error;
    }
    ir::TypeId element = type == body.types().error ? type : body.types()[type].element;
    ir::LocalId found = emit_temporary(body, "found", optional, body.context[stmt.value].span);
    ir::StmtId id = add(body.program(), ir::StmtOp::if_, stmt.span);
    ir::ExprId holder = make_local(body.program(), found, stmt.span);
    body.program().stmts[id].value = add(body.program(), ir::Op::has_value, body.types().bool_, stmt.span, {holder});

    std::vector<ir::StmtId> then_body;
    auto* outer = std::exchange(body.block, &then_body);
    open_scope(body);
    ir::LocalId local = declare_local(body, stmt.name, element, false);
    ir::StmtId let = add(body.program(), ir::StmtOp::let, stmt.name.span);
    body.program().stmts[let].local = local;
    body.program().stmts[let].value =
        add(body.program(), ir::Op::value, element, stmt.span, {make_local(body.program(), found, stmt.span)});
    emit(body, let);
    ++body.enclosing;
    check_block(body, stmt.body);
    --body.enclosing;
    close_scope(body);
    body.block = outer;
    body.program().stmts[id].body = std::move(then_body);
    auto otherwise = check_nested(body, stmt.otherwise);
    body.program().stmts[id].otherwise = std::move(otherwise);
    emit(body, id);
}

/// The statements, checked in a scope of their own.
std::vector<ir::StmtId> check_in_scope(Body& body, const std::vector<ast::StmtId>& statements) {
    std::vector<ir::StmtId> inner;
    auto* outer = std::exchange(body.block, &inner);
    open_scope(body);
    check_block(body, statements);
    close_scope(body);
    body.block = outer;
    return inner;
}

/// Checks one branch of an `if` with a constant condition, in a function with a workgroup. The branch may end in a
/// return: only the branch that is selected is kept, so that all invocations return together.
std::vector<ir::StmtId> check_branch(Body& body, const std::vector<ast::StmtId>& branch) {
    if (body.enclosing > 0 || body.loops > 0) return check_nested(body, branch);
    Span outer = std::exchange(body.last, branch.empty() ? Span{} : body.context[branch.back()].span);
    auto result = check_in_scope(body, branch);
    body.last = outer;
    return result;
}

/// Checks the branch of a pipeline's `if` that never runs. It makes no code, may wait for the device or return even in
/// an arm (sema/pipelines/predication.h), and leaves Body::host_needed, the first statement that only the host can
/// execute, as it was.
void check_dead_branch(Body& body, const std::vector<ast::StmtId>& branch) {
    const Span host_needed = body.host_needed;
    auto arms = std::exchange(body.arms, {});
    check_nested(body, branch);
    body.arms = std::move(arms);
    body.host_needed = host_needed;
}

/// Emits the branch `live` of a pipeline's `if` with a constant condition. The other branch makes no code. In a generic
/// instance it is not checked either, so that nothing is instantiated for it.
void keep_branch(Body& body, const std::vector<ast::StmtId>& live, const std::vector<ast::StmtId>& dead) {
    if (body.env.bindings.empty()) check_dead_branch(body, dead);
    for (ir::StmtId id : check_nested(body, live)) emit(body, id);
}

void check_if(Body& body, const ast::Stmt& stmt) {
    if (stmt.name.name) return check_if_let(body, stmt);
    ir::ExprId condition = check_hinted(body, stmt.value, body.types().bool_);
    if (body.kind == BodyKind::pipeline &&
        body.program().exprs[condition].type == body.types().device(body.types().bool_))
        return check_arms(body, stmt, condition);
    condition = coerce(body, condition, body.types().bool_, body.context[stmt.value].span);
    if (body.kind == BodyKind::function && body.grouped()) {
        if (auto known = known_value(body, condition)) {
            auto then_body = check_branch(body, stmt.body), otherwise = check_branch(body, stmt.otherwise);
            for (ir::StmtId id : known->bits() ? then_body : otherwise) emit(body, id);
            return;
        }
    }
    if (body.kind == BodyKind::pipeline) {
        if (auto known = known_value(body, condition))
            return keep_branch(body, known->bits() ? stmt.body : stmt.otherwise,
                               known->bits() ? stmt.otherwise : stmt.body);
    }
    ir::StmtId id = add(body.program(), ir::StmtOp::if_, stmt.span);
    auto then_body = check_nested(body, stmt.body), otherwise = check_nested(body, stmt.otherwise);
    ir::Stmt& node = body.program().stmts[id];
    node.value = condition;
    node.body = std::move(then_body);
    node.otherwise = std::move(otherwise);
    emit(body, id);
}

/// The value of a return. All returns of a pipeline give values of the host, or all give values on the device.
ir::ExprId returned(Body& body, const ast::Stmt& stmt) {
    if (body.kind != BodyKind::pipeline) return check_value(body, stmt.value, body.result);
    ir::ExprId value = to_value(body, check(body, stmt.value, body.result));
    if (is_error(body, value)) return value;
    ir::TypeId type = body.program().exprs[value].type;
    bool on_device = body.types().kind(type) == ir::TypeKind::device && body.types()[type].element == body.result;
    if (on_device && body.returns != Body::Returns::host) {
        body.returns = Body::Returns::device;
        return value;
    }
    Span span = body.context[stmt.value].span;
    if (body.returns == Body::Returns::device) return coerce(body, value, body.types().device(body.result), span);
    body.returns = Body::Returns::host;
    return coerce(body, value, body.result, span);
}

void check_return(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    if (is_refused_in_arm(body, "'return'", stmt.span, "assign a 'var' here, and return it at the end")) return;
    if (body.grouped() && body.last != stmt.span) {
        note(c.error(Diag::return_in_group, stmt.span), stmt.span,
             "invocations of a workgroup reach every barrier together: use 'if'");
        return;
    }
    if (body.range_result) return check_range_return(body, stmt);
    ir::StmtId id = add(body.program(), ir::StmtOp::return_, stmt.span);
    if (stmt.value) {
        if (body.result == body.types().void_) {
            c.error(Diag::return_value, c[stmt.value].span);
            check_value(body, stmt.value);
            return;
        }
        ir::ExprId value = returned(body, stmt);
        body.program().stmts[id].value = value;
    } else if (body.result && body.result != body.types().void_ && body.result != body.types().error) {
        c.error(Diag::return_nothing, stmt.span, {c.text(body.result)});
    }
    emit(body, id);
}

const char* barrier_name(ir::StmtOp barrier) { return barrier == ir::StmtOp::barrier ? "barrier" : "subgroupBarrier"; }

/// The kind of barrier, if the expression is a call of one.
std::optional<ir::StmtOp> barrier_of(Body& body, const ast::Expr& expr) {
    const Context& c = body.context;
    if (expr.kind != ast::ExprKind::call) return std::nullopt;
    const ast::Expr& callee = c[expr.operands[0]];
    if (callee.kind != ast::ExprKind::name || find_symbol(body, callee.name)) return std::nullopt;
    for (ir::StmtOp barrier : {ir::StmtOp::barrier, ir::StmtOp::subgroup_barrier})
        if (c.text(callee.name) == barrier_name(barrier)) return barrier;
    return std::nullopt;
}

void check_expression_statement(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    if (check_message(body, stmt)) return;
    if (const auto barrier = barrier_of(body, c[stmt.value])) {
        if (!body.grouped())
            note(c.error(Diag::needs_group, stmt.span, {barrier_name(*barrier)}), stmt.span,
                 "write 'group(size)' after the kernel's parameters");
        else emit(body, add(body.program(), *barrier, stmt.span));
        return;
    }
    Operand operand = check(body, stmt.value);
    if (operand.kind == OperandKind::error || !operand.expr) return;
    const ir::Expr& node = body.program().exprs[operand.expr];
    // A call without a value, such as s.store(…), whose statement check() has emitted.
    if (node.op == ir::Op::constant && node.type == body.types().void_) return;
    bool atomic = node.op == ir::Op::intrinsic && node.intrinsic >= ir::Intrinsic::atomicStore;
    if (node.op != ir::Op::call && node.op != ir::Op::pipeline_call && !atomic) {
        c.error(Diag::no_effect, c[stmt.value].span);
        return;
    }
    ir::StmtId id = add(body.program(), ir::StmtOp::evaluate, stmt.span);
    body.program().stmts[id].value = operand.expr;
    emit(body, id);
}

void check_jump(Body& body, const ast::Stmt& stmt) {
    bool is_break = stmt.kind == ast::StmtKind::break_;
    if (body.loops == 0 && is_refused_in_arm(body, is_break ? "'break'" : "'continue'", stmt.span,
                                             "let the loop's condition say so: for i in a..b while …"))
        return;
    if (body.loops == 0) body.context.error(Diag::outside_loop, stmt.span, {is_break ? "break" : "continue"});
    emit(body, add(body.program(), is_break ? ir::StmtOp::break_ : ir::StmtOp::continue_, stmt.span));
}

}  // namespace

std::vector<ir::StmtId> check_nested(Body& body, const std::vector<ast::StmtId>& statements) {
    ++body.enclosing;
    auto inner = check_in_scope(body, statements);
    --body.enclosing;
    return inner;
}

void check_block(Body& body, const std::vector<ast::StmtId>& statements) {
    for (ast::StmtId id : statements) {
        if (body.context.diagnostics.at_limit()) return;
        check_statement(body, id);
    }
}

void check_statement(Body& body, ast::StmtId id) {
    const ast::Stmt& stmt = body.context[id];
    if (body.depth > nesting_limit) {
        body.context.error(Diag::too_deep, stmt.span);
        return;
    }
    ++body.depth;
    const auto outer = std::exchange(body.pending, {});
    switch (stmt.kind) {
    case ast::StmtKind::error: break;
    case ast::StmtKind::let:
        if (body.kind != BodyKind::pipeline || !check_pipeline_statement(body, stmt)) check_let(body, stmt);
        break;
    case ast::StmtKind::shared: check_shared(body, stmt); break;
    case ast::StmtKind::temp:
        if (body.kind != BodyKind::pipeline) body.context.error(Diag::temp_outside_pipeline, stmt.span);
        else check_pipeline_statement(body, stmt);
        break;
    case ast::StmtKind::assign: check_assign(body, stmt); break;
    case ast::StmtKind::expression:
        if (body.kind != BodyKind::pipeline || !check_pipeline_statement(body, stmt))
            check_expression_statement(body, stmt);
        break;
    case ast::StmtKind::if_: check_if(body, stmt); break;
    case ast::StmtKind::for_: check_for(body, stmt); break;
    case ast::StmtKind::while_: check_while(body, stmt); break;
    case ast::StmtKind::switch_: check_switch(body, stmt); break;
    case ast::StmtKind::break_:
    case ast::StmtKind::continue_: check_jump(body, stmt); break;
    case ast::StmtKind::return_: check_return(body, stmt); break;
    case ast::StmtKind::discard: check_discard(body, stmt); break;
    case ast::StmtKind::block: {
        auto inner = check_nested(body, stmt.body);
        ir::StmtId block = add(body.program(), ir::StmtOp::block, stmt.span);
        body.program().stmts[block].body = std::move(inner);
        emit(body, block);
        break;
    }
    }
    body.pending = outer;
    --body.depth;
}

bool always_returns(const ir::Program& program, const std::vector<ir::StmtId>& statements) {
    for (ir::StmtId id : statements) {
        const ir::Stmt& stmt = program.stmts[id];
        if (stmt.op == ir::StmtOp::return_) return true;
        if (stmt.op == ir::StmtOp::block && always_returns(program, stmt.body)) return true;
        if (stmt.op == ir::StmtOp::if_ && !stmt.otherwise.empty() && always_returns(program, stmt.body) &&
            always_returns(program, stmt.otherwise))
            return true;
    }
    return false;
}

}  // namespace gliftc::sema
