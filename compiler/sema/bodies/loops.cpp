// `for` and `while`.
#include "sema/bodies/order.h"
#include "sema/pipelines/predication.h"
#include "sema/pipelines/values.h"
#include "sema/types/typing.h"

namespace gliftc::sema {

namespace {

/// Checks a bound of a range without an expected type; its type is then expected of the other bound. A value on the
/// device is an error.
ir::ExprId check_bound(Body& body, ast::ExprId bound) {
    const ir::ExprId value = check_value(body, bound);
    const ir::TypeId type = body.program().exprs[value].type;
    const bool is_on_device = body.types().kind(type) == ir::TypeKind::device;
    return is_on_device ? coerce(body, value, body.types()[type].element, body.context[bound].span) : value;
}

/// Checks both bounds of `a..b`, which have one type. A bound made of literals without suffix takes the type of the
/// other one. If both are made of such literals, the type is int if one of them is a unary operation, as `-1` is, else
/// uint.
std::pair<ir::ExprId, ir::ExprId> check_range(Body& body, const ast::Expr& range) {
    Context& c = body.context;
    bool low_flexible = is_flexible(c, range.operands[0]), high_flexible = is_flexible(c, range.operands[1]);
    bool negative =
        c[range.operands[0]].kind == ast::ExprKind::unary || c[range.operands[1]].kind == ast::ExprKind::unary;
    ir::ExprId low, high;
    if (low_flexible && high_flexible) {
        ir::TypeId type = negative ? body.types().int_ : body.types().uint;
        low = check_value(body, range.operands[0], type);
        high = check_value(body, range.operands[1], type);
    } else if (low_flexible) {
        Alternative last = recorded(body, [&] { return check_bound(body, range.operands[1]); });
        high = last.value;
        low = check_value(body, range.operands[0], body.program().exprs[high].type);
        append(body, std::move(last.steps));
    } else {
        low = check_bound(body, range.operands[0]);
        high = check_value(body, range.operands[1], body.program().exprs[low].type);
    }
    return {low, high};
}

}  // namespace

void check_for(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    const ast::Expr& range = c[stmt.value];
    if (range.kind != ast::ExprKind::range) {
        if (range.kind != ast::ExprKind::error) c.error(Diag::for_range, range.span);
        return;
    }
    auto [low, high] = check_range(body, range);
    // If a bound has an error, the loop variable gets the error type, so that its uses report nothing more.
    ir::TypeId type = body.program().exprs[is_error(body, high) ? high : low].type;
    bool wrong =
        !is_error(body, low) && !is_error(body, high) && type != body.types().int_ && type != body.types().uint;
    if (wrong) c.error(Diag::index_type, range.span, {c.text(type)});
    ir::StmtId id = add(body.program(), ir::StmtOp::for_, stmt.span);
    std::vector<ir::StmtId> inner, before;
    auto* outer = std::exchange(body.block, &inner);
    open_scope(body);
    ir::LocalId local = declare_local(body, stmt.name, type, false, false);
    if (stmt.condition) {
        check_rounds(body, stmt, before);
    } else {
        ++body.loops;
        check_block(body, stmt.body);
        --body.loops;
    }
    close_scope(body);
    body.block = outer;
    for (ir::StmtId statement : before) emit(body, statement);
    ir::Stmt& node = body.program().stmts[id];
    node.local = local;
    node.value = low;
    node.limit = high;
    node.body = std::move(inner);
    emit(body, id);
}

/// Statements that the condition emits are put into the loop's body, since the condition is evaluated in each
/// iteration.
void check_while(Body& body, const ast::Stmt& stmt) {
    std::vector<ir::StmtId> inner;
    auto* outer = std::exchange(body.block, &inner);
    ir::ExprId condition = check_hinted(body, stmt.value, body.types().bool_);
    body.pending.clear();
    if (is_on_device(body, condition)) {
        note(body.context.error(Diag::device_loop, body.context[stmt.value].span), stmt.span,
             "the host must know how many rounds there are at most: write 'for round in 0..most while …'");
        condition = error_value(body, stmt.span);
    }
    condition = coerce(body, condition, body.types().bool_, body.context[stmt.value].span);
    bool simple = inner.empty();
    if (!simple) {
        ir::StmtId leave = add(body.program(), ir::StmtOp::if_, stmt.span);
        ir::ExprId negated = add(body.program(), ir::Op::unary, body.types().bool_, stmt.span, {condition});
        body.program().exprs[negated].unary = ir::UnaryOp::logical_not;
        body.program().stmts[leave].value = negated;
        body.program().stmts[leave].body = {add(body.program(), ir::StmtOp::break_, stmt.span)};
        emit(body, leave);
    }
    open_scope(body);
    ++body.loops;
    check_block(body, stmt.body);
    --body.loops;
    close_scope(body);
    body.block = outer;
    ir::StmtId id = add(body.program(), ir::StmtOp::while_, stmt.span);
    ir::ExprId value = simple ? condition : make_bool(body.program(), true, stmt.span);
    body.program().stmts[id].value = value;
    body.program().stmts[id].body = std::move(inner);
    emit(body, id);
}

}  // namespace gliftc::sema
