#include "lower/analysis/staged_loads.h"

#include "ir/effects.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

/// A loop of fewer rounds, if their number is known, is not worth the barriers.
constexpr std::uint64_t fewest_rounds = 16;

}  // namespace

StagedLoads::StagedLoads(Context& context) : cx(context), numbers_(context) {
    for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) {
        slopes_.emplace_back(cx.p, cx.pass.address, 0, axis);
        for (const KernelParam& param : cx.kernel.params)
            if (param.local) slopes_.back().learn_steady(param.local);
    }
}

StagedLoop StagedLoads::of(const std::vector<StmtId>& body) {
    if (!find_loop(body)) return {};
    const Stmt loop = cx.p.stmts[found_.loop];
    const auto learn = [&](const std::vector<StmtId>& statements) {
        for (StmtId id : statements) {
            const Stmt& stmt = cx.p.stmts[id];
            for (RowSlopes& slopes : slopes_) slopes.learn(stmt);
            if (stmt.op == StmtOp::let && stmt.value && !cx.p.locals[stmt.local].is_mutable &&
                numbers_.is_fixed(stmt.value))
                numbers_.define(stmt.local, numbers_.of(stmt.value));
        }
    };
    learn(found_.before);
    if (!is_same_for_all(loop.value) || !is_same_for_all(loop.limit)) return {};
    for (RowSlopes& slopes : slopes_) slopes.learn_steady(loop.local);
    learn(loop.body);
    for (StmtId id : loop.body) {
        const Stmt& stmt = cx.p.stmts[id];
        if (stmt.value) visit(stmt.value);
    }
    return std::move(found_);
}

/// Whether the value is the same for all invocations of the pass.
bool StagedLoads::is_same_for_all(ExprId value) {
    const auto is_steady = [&](RowSlopes& slopes) { return slopes.is_steady(value); };
    return numbers_.is_fixed(value) && std::ranges::all_of(slopes_, is_steady);
}

bool StagedLoads::find_loop(const std::vector<StmtId>& body) {
    const auto is_loop = [&](StmtId id) { return cx.p.stmts[id].op == StmtOp::for_; };
    const auto at = std::ranges::find_if(body, is_loop);
    if (at == body.end()) return false;
    const Stmt& loop = cx.p.stmts[*at];
    found_.before.assign(body.begin(), at);
    found_.loop = *at;
    found_.after.assign(at + 1, body.end());
    if (cx.p.locals[loop.local].type != cx.p.types.uint) return false;
    const auto begin = cx.build.bits_of(loop.value), end = cx.build.bits_of(loop.limit);
    if (begin && end && *end < *begin + fewest_rounds) return false;
    return is_plain(found_.before, false) && is_plain(loop.body, false) && is_plain(found_.after, true);
}

/// Whether the statements can be executed for one element after the other, also for one that is not in the range if
/// they do not store.
bool StagedLoads::is_plain(const std::vector<StmtId>& body, bool may_store) const {
    return std::ranges::all_of(body, [&](StmtId id) { return is_plain(cx.p.stmts[id], may_store); });
}

bool StagedLoads::is_plain(const Stmt& stmt, bool may_store) const {
    switch (stmt.op) {
    case StmtOp::let:
    case StmtOp::assign: break;
    case StmtOp::if_:
    case StmtOp::block: break;
    case StmtOp::store:
    case StmtOp::image_store:
    case StmtOp::atomic:
        if (!may_store) return false;
        break;
    default: return false;
    }
    return !calls_a_function(stmt) && is_plain(stmt.body, may_store) && is_plain(stmt.otherwise, may_store);
}

/// Functions may have loops, and change workgroup memory.
bool StagedLoads::calls_a_function(const Stmt& stmt) const {
    bool found = false;
    for_each_root(stmt, [&](ExprId root) {
        for_each_node(cx.p, root, [&](ExprId id) {
            const Expr& node = cx.p.exprs[id];
            const bool is_atomic = node.op == Op::intrinsic && signature_of(node.intrinsic)[0] == '@';
            found = found || node.op == Op::call || is_atomic;
        });
    });
    return found;
}

/// Visits what is evaluated in every round.
void StagedLoads::visit(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (is_load(node.op) || node.op == Op::guarded_load) return note(id);
    const bool is_logical =
        node.op == Op::binary && (node.binary == BinaryOp::logical_and || node.binary == BinaryOp::logical_or);
    const std::size_t count = node.op == Op::select || is_logical ? 1 : node.operands.size();
    for (std::size_t i = 0; i < count; ++i) visit(cx.p.exprs[id].operands[i]);
}

bool StagedLoads::may_be_staged(const Expr& node) const {
    if (node.op != Op::load && node.op != Op::guarded_load) return false;
    const PassBinding& binding = cx.pass.bindings[node.slot];
    const Types& types = cx.p.types;
    if (binding.shape != MemoryShape::buffer || !(types.is_scalar(node.type) || types.is_vector(node.type)))
        return false;
    const TypeId scalar = types.scalar_of(node.type);
    return scalar == types.float_ || scalar == types.uint || scalar == types.int_;
}

void StagedLoads::note(ExprId id) {
    const Expr node = cx.p.exprs[id];
    if (!may_be_staged(node) || !numbers_.is_fixed(id)) return;
    is_varying_ = false;
    const Stmt& loop = cx.p.stmts[found_.loop];
    for (ExprId operand : node.operands)
        if (!is_function_of_address(operand, loop)) return;
    if (!is_varying_) return;
    StagedLoad load{{id}, node.slot};
    for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) {
        const auto is_same = [&](ExprId operand) { return slopes_[axis].is_steady(operand); };
        if (!std::ranges::all_of(node.operands, is_same)) load.axes |= 1u << axis;
    }
    load.is_row = slopes_[0].is_row(node.operands[node.op == Op::guarded_load ? 1 : 0]);
    if (load.axes == (1u << cx.pass.rank) - 1) return;
    const ValueNumber value = numbers_.of(id);
    const auto known = std::ranges::find(values_, value);
    if (known != values_.end())
        return found_.loads[static_cast<std::size_t>(known - values_.begin())].nodes.push_back(id);
    values_.push_back(value);
    found_.loads.push_back(std::move(load));
}

/// Whether the value is a function of the invocation's address, the loop's variable and uniform values, without loads.
/// Notes whether it mentions the variable.
bool StagedLoads::is_function_of_address(ExprId id, const Stmt& loop) {
    bool is_function = true;
    IdSet<Expr> seen;
    std::vector<ExprId> left{id};
    while (!left.empty() && is_function) {
        const ExprId whole = left.back();
        left.pop_back();
        for_each_node(cx.p, whole, seen, [&](ExprId part) {
            const Expr& node = cx.p.exprs[part];
            is_function &= !is_load(node.op) && node.op != Op::guarded_load && node.op != Op::builtin;
            if (node.op != Op::local || node.local == cx.pass.address) return;
            is_varying_ |= node.local == loop.local;
            if (node.local == loop.local) return;
            const ExprId* definition = cx.definitions.find(node.local);
            if (definition != nullptr) left.push_back(*definition);
            else is_function = false;
        });
    }
    return is_function;
}

}  // namespace gliftc::lower
