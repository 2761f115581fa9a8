#include "lower/analysis/unroll.h"

#include "ir/evaluate.h"
#include "ir/walk.h"

namespace gliftc::lower {

using namespace ir;

bool is_long_array(const Program& program, TypeId type) {
    if (program.types.kind(type) != TypeKind::array) return false;
    return program.types[type].count > unroll_limit || is_long_array(program, program.types[type].element);
}

std::optional<Rounds> rounds_of(const Program& program, ExprId first, ExprId limit) {
    auto low = evaluate(program, first), high = evaluate(program, limit);
    if (!low || !high) return std::nullopt;
    bool is_signed = program.types.is_signed(low->type);
    bool none = is_signed ? static_cast<std::int64_t>(low->bits()) >= static_cast<std::int64_t>(high->bits())
                          : low->bits() >= high->bits();
    return Rounds{low->bits(), none ? 0 : high->bits() - low->bits()};
}

bool indexes_array_by_loop(const Program& program, const Stmt& loop) {
    bool found = false;
    for_each_expression(program, loop.body, [&](ExprId id) {
        const Expr& node = program.exprs[id];
        if (node.op != Op::index || program.types.kind(program.exprs[node.operands[0]].type) != TypeKind::array) return;
        const Expr& array = place_of(program, node.operands[0]);
        if (array.op != Op::local || program.locals[array.local].storage == Storage::shared) return;
        for_each_node(program, node.operands[1], [&](ExprId part) {
            found = found || (program.exprs[part].op == Op::local && program.exprs[part].local == loop.local);
        });
    });
    return found;
}

bool has_near_depending_on_loop(const Program& program, const Stmt& loop) {
    IdSet<Local> inner;
    inner.insert(loop.local);
    for_each_statement(program, loop.body, [&](const Stmt& stmt) {
        if (stmt.op == StmtOp::let || stmt.op == StmtOp::for_) inner.insert(stmt.local);
    });
    bool depends = false;
    for_each_expression(program, loop.body, [&](ExprId id) {
        if (program.exprs[id].op != Op::near) return;
        for_each_node(program, program.exprs[id].operands[0], [&](ExprId part) {
            const Expr& node = program.exprs[part];
            depends = depends || (node.op == Op::local && inner.contains(node.local));
        });
    });
    return depends;
}

bool leaves_loop(const Program& program, const std::vector<StmtId>& body) {
    for (StmtId id : body) {
        const Stmt& stmt = program.stmts[id];
        if (stmt.op == StmtOp::break_ || stmt.op == StmtOp::continue_) return true;
        if (stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_) continue;
        if (leaves_loop(program, stmt.body) || leaves_loop(program, stmt.otherwise)) return true;
    }
    return false;
}

bool returns(const Program& program, const std::vector<StmtId>& body) {
    bool found = false;
    for_each_statement(program, body, [&](const Stmt& stmt) { found = found || stmt.op == StmtOp::return_; });
    return found;
}

}  // namespace gliftc::lower
