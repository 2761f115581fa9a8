#include "lower/split_blocks.h"

#include "lower/blocks.h"

namespace gliftc::lower {

using namespace ir;

std::optional<Variant> split_blocks(Context& cx, const Variant& variant) {
    Variant made = variant;
    made.body.clear();
    made.block.emplace();
    BlockValues values(cx);
    StmtId holds;
    for (StmtId id : variant.body) {
        const Stmt& stmt = cx.p.stmts[id];
        if (!holds && stmt.op == StmtOp::evaluate && cx.make.type(stmt.value) == cx.p.types.bool_) {
            if (!values.has(stmt.value)) return std::nullopt;
            holds = id;
            continue;
        }
        (values.has(stmt) ? *made.block : made.body).push_back(id);
    }
    if (!holds) return std::nullopt;
    made.block->push_back(holds);
    return made;
}

}  // namespace gliftc::lower
