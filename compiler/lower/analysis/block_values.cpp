#include "lower/analysis/block_values.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

bool BlockValues::has(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::builtin || !numbers_.is_fixed(id)) return false;
    if (node.op == Op::local) return node.local != cx.pass.address && !varying_.contains(node.local);
    // The address is {position in the block, number of the block}.
    const bool is_part = node.op == Op::swizzle && cx.p.exprs[node.operands[0]].op == Op::local &&
                         cx.p.exprs[node.operands[0]].local == cx.pass.address;
    if (is_part) return !cx.p.types.is_vector(node.type) && node.lanes[0] == 1;
    return std::ranges::all_of(node.operands, [&](ExprId operand) { return has(operand); });
}

bool BlockValues::has(const Stmt& stmt) {
    if (stmt.op != StmtOp::let) return false;
    const bool is_value = stmt.value && !cx.p.locals[stmt.local].is_mutable && has(stmt.value);
    if (!is_value) varying_.insert(stmt.local);
    return is_value;
}

}  // namespace gliftc::lower
