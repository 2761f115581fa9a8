#include "sema/bodies/order.h"

#include "base/id_set.h"
#include "ir/walk.h"
#include "sema/pipelines/values.h"

#include <utility>

namespace gliftc::sema {

namespace {

void add_nodes(const ir::Program& p, std::span<const ir::ExprId> roots, IdSet<ir::Expr>& nodes) {
    for (ir::ExprId root : roots) ir::for_each_node(p, root, nodes, [](ir::ExprId) {});
}

bool have_effect(const std::vector<Pending>& pending) { return std::ranges::any_of(pending, &Pending::has_effect); }

std::string_view name_for(const Body& body, const ir::Expr& node) {
    switch (node.op) {
    case ir::Op::call: return body.context.text(body.context.program.functions[node.function].name);
    case ir::Op::pipeline_call: return "found";
    case ir::Op::device_read:
    case ir::Op::host_read: return "element";
    case ir::Op::await_value: return "awaited";
    default: return "before";
    }
}

/// Emits a local for the node, which becomes a use of it. What it was is moved to another node.
void put_into_local(Body& body, ir::ExprId node) {
    ir::Program& p = body.program();
    ir::Expr moved = p.exprs[node];
    const Span span = moved.span;
    if (moved.op == ir::Op::device_read) moved.slot = 0;  // a copy, which later passes do not change
    const std::string name(name_for(body, moved));
    const ir::LocalId local = add_local(p, body.context.names.intern(name), moved.type, span);
    const ir::StmtId let = add(p, ir::StmtOp::let, span);
    p.stmts[let].local = local;
    p.stmts[let].value = p.exprs.add(std::move(moved));
    emit(body, let);
    p.exprs[node] = p.exprs[make_local(p, local, span)];
}

void make_pending(Body& body, ir::ExprId node, bool has_effect) {
    bool has_inner_effect = false, follows_effect = false;
    // Of a kernel, lowering makes statements of effects, in their order; C++ evaluates a pipeline's tree in any order.
    if (body.kind == BodyKind::pipeline && have_effect(body.pending)) {
        IdSet<ir::Expr> parts;
        add_nodes(body.program(), {&node, 1}, parts);
        for (const Pending& one : body.pending)
            (parts.contains(one.node) ? has_inner_effect : follows_effect) |= one.has_effect;
    }
    if (has_effect || follows_effect) settle(body, {&node, 1});
    body.pending.push_back({node, has_effect || has_inner_effect});
}

/// Emits `if condition { yes } else { no }`, each of which assigns a new variable. Gives the variable.
ir::ExprId emit_choice(Body& body, ir::ExprId condition, Alternative yes, Alternative no, Span span) {
    ir::Program& p = body.program();
    const ir::TypeId type = p.exprs[yes.value].type;
    const ir::LocalId chosen = add_local(p, body.context.names.intern("chosen"), type, span, true);
    const ir::StmtId let = add(p, ir::StmtOp::let, span), branch = add(p, ir::StmtOp::if_, span);
    settle(body, {&condition, 1});
    p.stmts[let].local = chosen;
    emit(body, let);
    p.stmts[branch].value = condition;
    const auto assigned = [&](Alternative& one) {
        const ir::StmtId assign = add(p, ir::StmtOp::assign, span);
        p.stmts[assign].target = make_local(p, chosen, span);
        p.stmts[assign].value = one.value;
        one.steps.statements.push_back(assign);
        return std::move(one.steps.statements);
    };
    auto then_body = assigned(yes), otherwise = assigned(no);
    p.stmts[branch].body = std::move(then_body);
    p.stmts[branch].otherwise = std::move(otherwise);
    emit(body, branch);
    return make_local(p, chosen, span);
}

/// A logical operation in a pipeline, whose right operand runs passes: they run only if the host's value on the left
/// does not decide.
ir::ExprId choose_pass(Body& body, ir::BinaryOp op, ir::ExprId left, Alternative right, Span span) {
    {
        const Recording recording(body, right.steps);
        right.value = on_device(body, right.value);
    }
    const bool is_and = op == ir::BinaryOp::logical_and;
    Alternative known = recorded(body, [&] { return on_device(body, make_bool(body.program(), !is_and, span)); });
    if (!is_and) std::swap(known, right);
    return opened(body, choose_value(body, left, std::move(right), std::move(known), span));
}

/// Makes the tree pending if one of the alternatives in it is.
ir::ExprId chosen_in_tree(Body& body, ir::ExprId tree, std::initializer_list<const Steps*> alternatives) {
    bool is_pending = false, has_effect = false;
    for (const Steps* steps : alternatives) {
        is_pending |= !steps->pending.empty();
        has_effect |= have_effect(steps->pending);
    }
    if (is_pending) make_pending(body, tree, has_effect);
    return tree;
}

}  // namespace

void add_read(Body& body, ir::ExprId node) { make_pending(body, node, false); }
void add_effect(Body& body, ir::ExprId node) { make_pending(body, node, true); }

bool is_changeable(const Body& body, ir::ExprId place) {
    const ir::Program& p = body.context.program;
    const ir::Expr& root = ir::place_of(p, place);
    return root.op == ir::Op::host_state ||
           (root.op == ir::Op::local && p.locals[root.local].storage == ir::Storage::shared);
}

void add_part(Body& body, ir::ExprId whole, ir::ExprId part) {
    if (!is_changeable(body, whole)) return;
    is_target(body, whole);
    add_read(body, part);
}

void is_target(Body& body, ir::ExprId node) {
    std::erase_if(body.pending, [&](const Pending& one) { return one.node == node; });
}

void settle(Body& body, std::span<const ir::ExprId> roots) {
    if (body.pending.empty() || !body.block) return;
    IdSet<ir::Expr> parts;
    add_nodes(body.program(), roots, parts);
    for (const Pending& one : std::exchange(body.pending, {}))
        if (!parts.contains(one.node)) put_into_local(body, one.node);
}

Recording::Recording(Body& body, Steps& steps)
    : body_(body), steps_(steps), block_(body.block), pending_(std::exchange(body.pending, std::move(steps.pending))) {
    if (body.block) body.block = &steps.statements;
}

Recording::~Recording() {
    body_.block = block_;
    steps_.pending = std::exchange(body_.pending, std::move(pending_));
}

void append(Body& body, Steps&& steps) {
    if (!steps.statements.empty() || have_effect(steps.pending) || have_effect(body.pending)) settle(body);
    for (ir::StmtId id : steps.statements) emit(body, id);
    body.pending.insert(body.pending.end(), steps.pending.begin(), steps.pending.end());
}

ir::ExprId choose_value(Body& body, ir::ExprId condition, Alternative yes, Alternative no, Span span) {
    if (is_open(body, condition)) {
        for (Alternative* one : {&yes, &no}) append(body, std::exchange(one->steps, {}));
    }
    if (!yes.steps.statements.empty() || !no.steps.statements.empty())
        return emit_choice(body, condition, std::move(yes), std::move(no), span);
    const ir::TypeId type = body.program().exprs[yes.value].type;
    const ir::ExprId tree = add(body.program(), ir::Op::select, type, span, {condition, yes.value, no.value});
    return chosen_in_tree(body, tree, {&yes.steps, &no.steps});
}

ir::ExprId choose_logical(Body& body, ir::BinaryOp op, ir::ExprId left, Alternative right, Span span) {
    ir::Program& p = body.program();
    if (is_open(body, left)) append(body, std::exchange(right.steps, {}));
    const bool is_part = right.steps.statements.empty() && !have_effect(right.steps.pending);
    if (is_open(body, right.value) && !is_part) return choose_pass(body, op, left, std::move(right), span);
    if (right.steps.statements.empty())
        return chosen_in_tree(body, make_binary(p, op, p.types.bool_, left, right.value, span), {&right.steps});
    Alternative known{make_bool(p, op == ir::BinaryOp::logical_or, span), {}};
    return op == ir::BinaryOp::logical_and ? emit_choice(body, left, std::move(right), std::move(known), span)
                                           : emit_choice(body, left, std::move(known), std::move(right), span);
}

}  // namespace gliftc::sema
