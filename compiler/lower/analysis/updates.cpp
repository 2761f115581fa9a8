#include "lower/analysis/updates.h"

#include "ir/effects.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

void learn_parameters(RowSlopes& slopes, const Kernel& kernel) {
    for (const KernelParam& param : kernel.params)
        if (param.local) slopes.learn_steady(param.local);
}

}  // namespace

Updates::Updates(Context& context) : cx(context), numbers_(context) {
    for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) {
        slopes_.emplace_back(cx.p, cx.pass.address, 0, axis);
        learn_parameters(slopes_.back(), cx.kernel);
    }
    if (cx.pass.of_blocks) of_block_.emplace(cx);
}

std::vector<Update> Updates::of(const std::vector<StmtId>& body) {
    for (StmtId id : body) visit(id);
    return has_return_ ? std::vector<Update>{} : std::move(found_);
}

bool Updates::is_same_along(std::uint32_t axis, ExprId value) {
    return numbers_.is_fixed(value) && slopes_[axis].is_steady(value);
}

/// Takes note of a `let`. What a block decides is the same for its elements, which lie along x.
void Updates::learn(RowSlopes& slopes, std::uint32_t axis, const Stmt& let) {
    if (axis == 0 && locals_of_block_.contains(let.local)) slopes.learn_steady(let.local);
    else slopes.learn(let);
}

void Updates::visit(StmtId id) {
    const Stmt& stmt = cx.p.stmts[id];
    for_each_root(stmt, [&](ExprId root) {
        for_each_node(cx.p, root, seen_, [&](ExprId node) {
            has_loop_ = has_loop_ || calls_a_loop(node);
            loads_ += is_load(cx.p.exprs[node].op);
        });
    });
    if (stmt.op == StmtOp::let) {
        if (of_block_ && of_block_->has(stmt)) locals_of_block_.insert(stmt.local);
        for (std::uint32_t axis = 0; axis < slopes_.size(); ++axis) learn(slopes_[axis], axis, stmt);
        lets_.push_back(id);
    }
    switch (stmt.op) {
    case StmtOp::atomic: return note(id);
    case StmtOp::if_: return visit_if(stmt);
    case StmtOp::block: return visit_all(stmt.body);
    case StmtOp::let:
    case StmtOp::assign:
    case StmtOp::evaluate:
    case StmtOp::report:
    case StmtOp::store:
    case StmtOp::image_store:
    case StmtOp::break_:
    case StmtOp::continue_: return;
    case StmtOp::for_:
    case StmtOp::while_: return visit_loop(stmt);
    default: has_return_ = true;
    }
}

void Updates::visit_all(const std::vector<StmtId>& body) {
    for (StmtId id : body) visit(id);
}

/// What a block decides is not known in loops, whose variables BlockValues does not know.
void Updates::visit_loop(const Stmt& stmt) {
    has_loop_ = true;
    of_block_.reset();
    ++depth_;
    visit_all(stmt.body);
    --depth_;
}

void Updates::visit_if(const Stmt& stmt) {
    conditions_.push_back({stmt.value, true});
    visit_all(stmt.body);
    conditions_.back().is_true = false;
    visit_all(stmt.otherwise);
    conditions_.pop_back();
}

bool Updates::calls_a_loop(ExprId id) const {
    const Expr& node = cx.p.exprs[id];
    return node.op == Op::call && contains_loop(cx.p.functions[node.function].body);
}

bool Updates::contains_loop(const std::vector<StmtId>& body) const {
    bool found = false;
    for_each_statement(
        cx.p, body, [&](const Stmt& stmt) { found = found || stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_; });
    for_each_expression(cx.p, body, [&](ExprId id) { found = found || calls_a_loop(id); });
    return found;
}

/// Whether the index is a sum of parts of the element's address, each times a factor that is the same for all
/// elements: then elements along x have different ones, unless all have the same.
bool Updates::is_affine(ExprId index) {
    const Expr node = cx.p.exprs[index];
    const auto is_steady = [&](ExprId id) { return slopes_[0].is_steady(id); };
    const auto is_operand_affine = [&](ExprId id) { return is_affine(id); };
    if (is_steady(index)) return true;
    switch (node.op) {
    case Op::local: {
        const ExprId* definition = cx.definitions.find(node.local);
        return node.local == cx.pass.address || (definition != nullptr && is_affine(*definition));
    }
    case Op::swizzle:
    case Op::construct: return std::ranges::all_of(node.operands, is_operand_affine);
    case Op::binary: break;
    default: return false;
    }
    const bool is_product = node.binary == BinaryOp::multiply;
    if (!is_product && node.binary != BinaryOp::add && node.binary != BinaryOp::subtract) return false;
    return (!is_product || std::ranges::any_of(node.operands, is_steady)) &&
           std::ranges::all_of(node.operands, is_operand_affine);
}

/// Whether the value can be computed where the body's locals are not declared (StatementCopy::with_definitions): it
/// does not use a variable, such as one that a function takes and ignores.
bool Updates::has_definition(ExprId value) const {
    bool holds = true;
    for_each_node(cx.p, value, [&](ExprId id) {
        const Expr& node = cx.p.exprs[id];
        if (node.op != Op::local) return;
        const ExprId* definition = cx.definitions.find(node.local);
        holds = holds && !cx.p.locals[node.local].is_mutable && (definition == nullptr || has_definition(*definition));
    });
    return holds;
}

/// Whether elements that differ along another axis than those in `same_along` have different addresses. Known for one
/// such axis, and an odd step: then no two of its 2^32 addresses are equal.
bool Updates::differs(ExprId target, std::uint8_t same_along) {
    std::uint32_t axes = 0;
    bool is_odd = true;
    for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) {
        if ((same_along >> axis & 1) != 0) continue;
        ++axes;
        const Slope slope = slopes_[axis].of(target)[0];
        is_odd = is_odd && slope.known && slope.step % 2 != 0;
    }
    return axes == 0 || (axes == 1 && is_odd);
}

/// The run of the target's address. It decides how fast the pass is, not what it computes: the element's address may
/// begin anywhere.
std::uint32_t Updates::run_of(ExprId target) {
    if (!numbers_.is_fixed(target)) return 1;
    for (std::uint32_t run : {16u, 8u, 4u}) {
        RowSlopes slopes(cx.p, cx.pass.address, run);
        slopes.assume_aligned();
        learn_parameters(slopes, cx.kernel);
        for (StmtId let : lets_) learn(slopes, 0, cx.p.stmts[let]);
        if (slopes.is_steady(target)) return run;
    }
    return 1;
}

void Updates::note(StmtId id) {
    const ExprId target = cx.p.stmts[id].target;
    Update update{id, conditions_};
    for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis)
        if (is_same_along(axis, target) && has_definition(target)) update.same_along |= 1u << axis;
    update.differs = differs(target, update.same_along);
    update.may_collide = slopes_[0].is_steady(target) || !is_affine(target);
    update.is_in_loop = depth_ != 0;
    if ((update.same_along & 1) == 0 && has_definition(target)) update.run = run_of(target);
    found_.push_back(std::move(update));
}

}  // namespace gliftc::lower
