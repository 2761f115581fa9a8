// Control flow of pipelines on conditions that the host does not know (sema/pipelines/predication.h). A variable that
// is declared outside an arm and assigned in it lies on the device, and keeps its value where the arm does not run.
#include "sema/pipelines/predication.h"

#include "ir/walk.h"
#include "sema/bodies/order.h"
#include "sema/pipelines/values.h"

#include <algorithm>
#include <utility>

namespace gliftc::sema {

namespace {

/// How many arms were around the declaration of the local; 0 for a local that declare_variable() has not recorded.
std::size_t depth_of(const Body& body, ir::LocalId local) {
    const auto found = body.depths.find(local);
    return found == body.depths.end() ? 0 : found->second;
}

/// Whether all arms from number `depth` on (0 is the outermost) run: the conjunction of their conditions, each negated
/// if its arm is the one that runs when the condition is false. An open expression, for a pass to compute
/// (sema/pipelines/values.h).
ir::ExprId runs(Body& body, std::size_t depth, Span span) {
    ir::Program& p = body.program();
    ir::ExprId all;
    for (std::size_t i = depth; i < body.arms.size(); ++i) {
        ir::ExprId one = opened(body, make_local(p, body.arms[i].condition, span));
        if (!body.arms[i].where) {
            one = add(p, ir::Op::unary, p.types.bool_, span, {one});
            p.exprs[one].unary = ir::UnaryOp::logical_not;
        }
        all = all ? make_binary(p, ir::BinaryOp::logical_and, p.types.bool_, all, one, span) : one;
    }
    return all;
}

/// Whether the value calls a function. An assignment in an arm to a variable declared outside is a `select`, whose pass
/// must run even where the arm does not, to keep the old value. A pass that calls functions must not run there: their
/// arguments may be values that passes of the arm did not compute, with which a loop in a function might not end. So a
/// value with a call gets a pass of its own before the `select`.
bool calls_functions(Body& body, ir::ExprId value) {
    bool found = false;
    ir::for_each_node(body.program(), value,
                      [&](ir::ExprId node) { found = found || body.program().exprs[node].op == ir::Op::call; });
    return found;
}

/// An `arms` statement on the condition, without statements yet.
ir::StmtId arm_of(Body& body, ir::LocalId condition, Span span) {
    const ir::StmtId id = add(body.program(), ir::StmtOp::arms, span);
    body.program().stmts[id].value = make_local(body.program(), condition, span);
    return id;
}

}  // namespace

bool is_refused_in_arm(Body& body, std::string_view what, Span span, std::string remedy) {
    if (body.arms.empty()) return false;
    Diagnostic& diagnostic = body.context.error(Diag::in_device_arm, span, {what});
    note(diagnostic, body.arms.back().span,
         "this condition lives on the device: the host goes through the arm in any case");
    note(diagnostic, span, std::move(remedy));
    return true;
}

void needs_host(Body& body, Span span) {
    if (!body.host_needed) body.host_needed = span;
}

void declare_variable(Body& body, ir::LocalId local) { body.depths[local] = body.arms.size(); }

bool lies_on_device_later(const Body& body, Span name) {
    return std::ranges::find(body.device_variables, name) != body.device_variables.end();
}

bool is_of_innermost_arm(const Body& body, ir::LocalId local) { return depth_of(body, local) == body.arms.size(); }

ir::ExprId as_declared(Body& body, ir::ExprId value, Span name) {
    return lies_on_device_later(body, name) && !is_on_device(body, value) ? on_device(body, value) : value;
}

void check_variable(Body& body, const ast::Stmt& stmt, ir::ExprId target) {
    ir::Program& p = body.program();
    const ir::LocalId local = p.exprs[target].local;
    const bool was_on_device = is_on_device(body, target);
    const ir::TypeId type = was_on_device ? p.types[p.exprs[target].type].element : p.exprs[target].type;
    const std::size_t depth = depth_of(body, local);
    const Span span = body.context[stmt.value].span;
    ir::ExprId value;
    {
        const Parts parts(body);
        value = stmt.op ? check_compound(body, stmt, opened(body, target)) : check_value(body, stmt.value, type);
        if (is_error(body, value)) return;
    }
    const bool is_partial = body.arms.size() > depth;
    if (!was_on_device && (is_partial || is_open(body, value))) {
        Context& c = body.context;
        if (!lies_on_device_later(body, p.locals[local].span)) body.device_variables.push_back(p.locals[local].span);
        // The declaration has usually reported already that a value of this type cannot lie on the device.
        else if (c.diagnostics.own_error_count() == 0) c.error(Diag::device_value_type, span, {c.text(type)});
        return;
    }
    if (is_partial) {
        if (calls_functions(body, value)) value = opened(body, on_device(body, value));
        const ir::ExprId where = runs(body, depth, stmt.span);
        value = add(p, ir::Op::select, type, span, {where, value, opened(body, target)});
    }
    value = was_on_device && !is_open(body, value) ? on_device(body, value) : closed(body, value);
    if (is_error(body, value)) return;
    const ir::StmtId assign = add(p, ir::StmtOp::assign, stmt.span);
    p.stmts[assign].target = target;
    p.stmts[assign].value = value;
    emit(body, assign);
}

ir::LocalId condition_local(Body& body, ir::ExprId condition) {
    const ir::Expr& expr = body.program().exprs[condition];
    if (expr.op == ir::Op::local && !body.program().locals[expr.local].is_mutable) return expr.local;
    return emit_temporary(body, "condition", condition, expr.span);
}

void check_arms(Body& body, const ast::Stmt& stmt, ir::ExprId condition) {
    const Span span = body.context[stmt.value].span;
    const ir::LocalId local = condition_local(body, condition);
    const ir::StmtId id = arm_of(body, local, stmt.span);
    const unsigned loops = std::exchange(body.loops, 0);
    body.arms.push_back({local, true, span});
    auto then_body = check_nested(body, stmt.body);
    body.arms.back().where = false;
    auto otherwise = check_nested(body, stmt.otherwise);
    body.arms.pop_back();
    body.loops = loops;
    body.program().stmts[id].body = std::move(then_body);
    body.program().stmts[id].otherwise = std::move(otherwise);
    emit(body, id);
}

namespace {

/// Emits one round of `for i in a..b while c`, where c lies on the device; the host records all rounds. `running` is a
/// variable on the device: whether c was true in all rounds so far. `statements` compute what c needs. They, and the
/// body, are emitted as arms on the condition `running`.
void check_round(Body& body, const ast::Stmt& stmt, ir::LocalId running, ir::ExprId condition,
                 std::vector<ir::StmtId> statements) {
    ir::Program& p = body.program();
    const Span span = p.exprs[condition].span;
    const ir::StmtId next = add(p, ir::StmtOp::assign, span);
    std::vector<ir::StmtId>* const round = std::exchange(body.block, &statements);
    const ir::ExprId before = opened(body, make_local(p, running, span));
    const ir::ExprId both = make_binary(p, ir::BinaryOp::logical_and, p.types.bool_, before, condition, span);
    p.stmts[next].target = make_local(p, running, span);
    const ir::ExprId value = closed(body, both);
    p.stmts[next].value = value;
    emit(body, next);
    body.block = round;
    if (statements.size() == 1) {
        emit(body, next);
    } else {
        const ir::StmtId asks = arm_of(body, running, span);
        p.stmts[asks].body = std::move(statements);
        emit(body, asks);
    }
    const ir::StmtId id = arm_of(body, running, stmt.span);
    const unsigned loops = std::exchange(body.loops, 0);
    body.arms.push_back({running, true, span});
    auto inner = check_nested(body, stmt.body);
    body.arms.pop_back();
    body.loops = loops;
    p.stmts[id].body = std::move(inner);
    emit(body, id);
}

void leave_unless(Body& body, ir::ExprId condition, Span span) {
    ir::Program& p = body.program();
    const ir::StmtId leave = add(p, ir::StmtOp::if_, span);
    const ir::ExprId negated = add(p, ir::Op::unary, p.types.bool_, span, {condition});
    p.exprs[negated].unary = ir::UnaryOp::logical_not;
    p.stmts[leave].value = negated;
    p.stmts[leave].body = {add(p, ir::StmtOp::break_, span)};
    emit(body, leave);
}

}  // namespace

void check_rounds(Body& body, const ast::Stmt& stmt, std::vector<ir::StmtId>& before) {
    const Span span = body.context[stmt.condition].span;
    Steps steps;
    ir::ExprId condition;
    {
        const Parts parts(body);
        const Recording recording(body, steps);
        condition = check_value(body, stmt.condition, body.types().bool_);
    }
    std::vector<ir::StmtId>& statements = steps.statements;
    if (is_error(body, condition) || !is_open(body, condition)) {
        for (ir::StmtId id : statements) emit(body, id);
        if (!is_error(body, condition)) leave_unless(body, condition, span);
        ++body.loops;
        check_block(body, stmt.body);
        --body.loops;
        return;
    }
    auto* const round = std::exchange(body.block, &before);
    const ir::ExprId yes = on_device(body, make_bool(body.program(), true, span));
    const ir::LocalId running = emit_temporary(body, "running", yes, span);
    body.program().locals[running].is_mutable = true;
    body.block = round;
    check_round(body, stmt, running, condition, std::move(statements));
}

}  // namespace gliftc::sema
