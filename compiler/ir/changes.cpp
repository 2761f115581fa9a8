#include "ir/changes.h"

#include "ir/walk.h"

namespace gliftc::ir {

namespace {

/// Whether the call changes its container, or one that it is given, and that is the calling pipeline's own container or
/// a member of it: a structure that no local names.
bool changes_caller(const Program& program, const Expr& call) {
    const Pipeline& called = program.pipelines[PipelineId{call.slot}];
    if (called.changes_owner && !call.local) return true;
    for (std::size_t i = 0; i < called.params.size(); ++i) {
        const PipelineParam& param = called.params[i];
        if (!may_be_changed(program, param)) continue;
        const Expr& argument = program.exprs[call.operands[i]];
        if (argument.op == Op::structure_value && !argument.local) return true;
    }
    return false;
}

}  // namespace

bool may_be_changed(const Program& program, const PipelineParam& param) {
    return param.pattern == HostPattern::structure && param.direction != Direction::in &&
           program.structures[param.structure].is_container;
}

bool changes_owner(const Program& program, const Pipeline& pipeline) {
    bool changes = false;
    for_each_statement(program, pipeline.body, [&](const Stmt& stmt) {
        changes = changes || stmt.op == StmtOp::replace || stmt.op == StmtOp::host_assign;
    });
    for_each_expression(program, pipeline.body, [&](ExprId id) {
        const Expr& expr = program.exprs[id];
        changes = changes || (expr.op == Op::pipeline_call && changes_caller(program, expr));
    });
    return changes;
}

}  // namespace gliftc::ir
