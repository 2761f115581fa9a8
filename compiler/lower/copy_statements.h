// Statements once more, with other values in the place of some.
#pragma once

#include "lower/context.h"
#include "lower/node_map.h"

namespace gliftc::lower {

/// Copies statements of one body for another address, with locals of their own. Expressions are folded anew.
class StatementCopy {
public:
    StatementCopy(Context& context, ExprId address) : cx(context) { locals_[context.pass.address] = address; }

    /// What stands for an expression, or for a local, in the copies.
    void replace(ExprId id, ExprId by) { made_.emplace(id, by); }
    void replace(LocalId local, ExprId by) { locals_[local] = by; }

    ExprId of(ExprId id);
    StmtId of(StmtId id);

private:
    ExprId again(ExprId id);
    void declare(ir::Stmt& stmt);

    Context& cx;
    NodeMap<LocalId, ExprId> locals_{cx.first_local};
    NodeMap<ExprId, ExprId> made_{cx.first_expr};
};

}  // namespace gliftc::lower
