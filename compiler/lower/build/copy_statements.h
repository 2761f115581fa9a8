// Copies statements with some values replaced.
#pragma once

#include "lower/build/node_map.h"
#include "lower/context.h"

namespace gliftc::lower {

/// Copies statements of a body, with `address` in place of the address of the invocation's element. Locals that `let`s
/// declare are copied, too; expressions are folded again.
class StatementCopy {
public:
    StatementCopy(Context& context, ExprId address) : cx(context) { locals_[context.pass.address] = address; }

    /// Says that copies have `by` in place of an expression or a local.
    void replace(ExprId id, ExprId by) { made_.emplace(id, by); }
    void replace(LocalId local, ExprId by) { locals_[local] = by; }

    ExprId of(ExprId id);
    StmtId of(StmtId id);
    /// A copy of the expression with their definitions in place of the body's locals that have one: it can stand where
    /// these are not declared.
    ExprId with_definitions(ExprId id);

private:
    ExprId again(ExprId id);
    void declare(ir::Stmt& stmt);

    Context& cx;
    NodeMap<LocalId, ExprId> locals_{cx.first_local};
    NodeMap<ExprId, ExprId> made_{cx.first_expr};
};

}  // namespace gliftc::lower
