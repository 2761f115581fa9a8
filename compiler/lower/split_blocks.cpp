#include "lower/split_blocks.h"

#include "ir/walk.h"
#include "lower/number.h"

namespace gliftc::lower {

using namespace ir;

namespace {

class Splitting {
public:
    explicit Splitting(Context& context) : cx(context), numbers_(context) {}

    /// Whether the value is the same for all elements of a block, and does not change in the pass.
    bool is_of_block(ExprId id) {
        const Expr& node = cx.p.exprs[id];
        if (node.op == Op::builtin || !numbers_.is_fixed(id)) return false;
        if (node.op == Op::local) return node.local != cx.pass.address && !varying_.contains(node.local);
        // The address is {position in the block, number of the block}.
        if (node.op == Op::swizzle && cx.p.exprs[node.operands[0]].op == Op::local &&
            cx.p.exprs[node.operands[0]].local == cx.pass.address)
            return !cx.p.types.is_vector(node.type) && node.lanes[0] == 1;
        for (ExprId operand : node.operands)
            if (!is_of_block(operand)) return false;
        return true;
    }
    void vary(LocalId local) { varying_.insert(local); }

private:
    Context& cx;
    Numbers numbers_;
    IdSet<Local> varying_;
};

}  // namespace

std::optional<Variant> split_blocks(Context& cx, const Variant& variant) {
    Variant made = variant;
    made.body.clear();
    made.block.emplace();
    Splitting splitting(cx);
    StmtId holds;
    for (StmtId id : variant.body) {
        const Stmt& stmt = cx.p.stmts[id];
        if (!holds && stmt.op == StmtOp::evaluate && cx.make.type(stmt.value) == cx.p.types.bool_) {
            if (!splitting.is_of_block(stmt.value)) return std::nullopt;
            holds = id;
            continue;
        }
        const bool is_value = stmt.op == StmtOp::let && stmt.value && !cx.p.locals[stmt.local].is_mutable;
        if (is_value && splitting.is_of_block(stmt.value)) {
            made.block->push_back(id);
            continue;
        }
        if (stmt.op == StmtOp::let) splitting.vary(stmt.local);
        made.body.push_back(id);
    }
    if (!holds) return std::nullopt;
    made.block->push_back(holds);
    return made;
}

}  // namespace gliftc::lower
