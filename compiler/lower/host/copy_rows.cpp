#include "lower/host/copy_rows.h"

#include "ir/walk.h"
#include "lower/analysis/slopes.h"
#include "lower/build/rewrite.h"

namespace gliftc::lower {

using namespace ir;

namespace {

/// How values change from one iteration of the loop to the next. All locals are constant in it but the loop's variable
/// and the array that it fills.
RowSlopes slopes_of(const Context& cx, const Stmt& loop) {
    RowSlopes slopes(cx.p, loop.local);
    for_each_expression(cx.p, loop.body, [&](ExprId id) {
        const Expr& node = cx.p.exprs[id];
        if (node.op == Op::local && node.local != loop.local) slopes.learn_steady(node.local);
    });
    return slopes;
}

/// The expression with 0 in place of the loop's variable: its value in the first iteration.
ExprId at_first(Context& cx, LocalId local, ExprId id) {
    const Expr node = cx.p.exprs[id];
    if (node.op == Op::local && node.local == local) return cx.build.uint(0);
    Operands operands;
    for (ExprId operand : node.operands) operands.push_back(at_first(cx, local, operand));
    return operands == node.operands ? id : cx.build.again(node, std::move(operands));
}

/// Whether the loop is `for x in 0..n { array[to + x] = memory[from + x]; }` with a constant n, and the binding of the
/// memory is only read, not coherent and not of bools. A loop along x over elements of the next block (halos.cpp) has a
/// limit that is not a constant: it copies few elements and stays as it is.
bool is_copy(const Context& cx, const Stmt& loop) {
    if (loop.op != StmtOp::for_ || loop.body.size() != 1 || cx.build.bits_of(loop.value) != 0 ||
        !cx.build.is_constant(loop.limit))
        return false;
    const Stmt& assign = cx.p.stmts[loop.body[0]];
    if (assign.op != StmtOp::assign) return false;
    const Expr &target = cx.p.exprs[assign.target], &load = cx.p.exprs[assign.value];
    if (target.op != Op::index || load.op != Op::load || cx.p.exprs[target.operands[0]].op != Op::local) return false;
    const PassBinding& binding = cx.pass.bindings[load.slot];
    const bool is_plain = binding.access == Access::read && !binding.coherent && load.type == binding.element;
    if (!is_plain || cx.p.types.scalar_of(load.type) == cx.p.types.bool_) return false;
    RowSlopes slopes = slopes_of(cx, loop);
    return slopes.is_row(target.operands[1]) && slopes.is_row(load.operands[0]);
}

StmtId visited(Context& cx, StmtId id) {
    const Stmt loop = cx.p.stmts[id];
    if (!is_copy(cx, loop))
        return cx.build.again(
            id, {loop.target, loop.value, loop.limit, copy_rows(cx, loop.body), copy_rows(cx, loop.otherwise)});
    const Stmt assign = cx.p.stmts[loop.body[0]];
    Stmt copy = statement(StmtOp::copy_row, assign.span);
    copy.slot = cx.p.exprs[assign.value].slot;
    copy.target = at_first(cx, loop.local, assign.target);
    copy.value = at_first(cx, loop.local, ExprId(cx.p.exprs[assign.value].operands[0]));
    copy.limit = loop.limit;
    return cx.add(std::move(copy));
}

}  // namespace

std::vector<StmtId> copy_rows(Context& cx, const std::vector<StmtId>& body) {
    std::vector<StmtId> result;
    result.reserve(body.size());
    for (StmtId id : body) result.push_back(visited(cx, id));
    return result;
}

}  // namespace gliftc::lower
