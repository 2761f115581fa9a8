#include "lower/host/lockstep.h"

#include "ir/effects.h"
#include "ir/walk.h"
#include "lower/analysis/number.h"
#include "lower/analysis/slopes.h"
#include "lower/build/copy_statements.h"
#include "lower/transform/dead.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

/// A loop of fewer rounds, if their number is known, is left to the C++ compiler, which unrolls it.
constexpr std::uint64_t fewest_rounds = 16;
/// The most bytes of an element's values that are kept from one part of the body to the next.
constexpr std::uint32_t most_kept_bytes = 128;

class Lockstep {
public:
    explicit Lockstep(Context& context)
        : cx(context), numbers_(context), slopes_(context.p, context.pass.address),
          outside_(context, context.build.local(context.pass.address)) {}

    std::optional<std::vector<StmtId>> run(const std::vector<StmtId>& body) {
        if (!find_loop(body)) return std::nullopt;
        learn_before();
        const Stmt loop = cx.p.stmts[loop_];
        if (!is_same(loop.value) || !is_same(loop.limit)) return std::nullopt;
        slopes_.learn_steady(loop.local);
        outside_locals_.insert(loop.local);
        varying_.insert(loop.local);
        for (StmtId id : loop.body) sort(id);
        return find_kept() ? std::optional(drop_dead(cx, whole())) : std::nullopt;
    }

private:
    bool find_loop(const std::vector<StmtId>& body);
    bool is_plain(const std::vector<StmtId>& body, bool may_store);
    bool is_plain(const Stmt& stmt, bool may_store);
    void learn_before();
    void recompute(StmtId let);
    bool is_stable(ExprId id);
    bool is_affine(const Stmt& let);
    bool is_same(ExprId id);
    bool is_same_after_cuts(ExprId id, std::vector<Stmt>& cuts);
    bool is_component_same(ExprId less, std::uint32_t component, std::vector<Stmt>& cuts);
    ExprId component(ExprId id, std::uint32_t at);
    bool uses_only(ExprId id, const IdSet<Local>& locals) const;
    bool varies(ExprId id);
    void sort(StmtId id);
    bool find_kept();
    bool is_small(TypeId type, std::uint32_t& bytes) const;
    std::vector<StmtId> whole();
    StmtId region(const std::vector<StmtId>& body);

    Context& cx;
    Numbers numbers_;
    RowSlopes slopes_;
    std::vector<StmtId> before_, after_;
    StmtId loop_;
    std::vector<StmtId> affine_;     ///< lets that advance along the row or stay the same, also from round to round
    std::vector<StmtId> once_;       ///< lets that a round executes once for the run
    std::vector<StmtId> invariant_;  ///< lets of a round that differ from element to element, not from round to round
    std::vector<StmtId> round_;      ///< what a round executes for each element
    std::vector<Stmt> cuts_;
    IdSet<Local> recomputed_;      ///< the locals of affine_, which each part of the body computes anew
    IdSet<Local> same_;            ///< those of once_ that have the same value for all elements of the run
    IdSet<Local> outside_locals_;  ///< whose value for the run's first element is known outside of `invocations`
    IdSet<Local> varying_;         ///< that may differ from round to round
    std::vector<LocalId> kept_;
    StatementCopy outside_;  ///< what is executed once for the run, with the address of its first element
};

bool Lockstep::find_loop(const std::vector<StmtId>& body) {
    const auto at = std::ranges::find_if(body, [&](StmtId id) { return cx.p.stmts[id].op == StmtOp::for_; });
    if (at == body.end()) return false;
    loop_ = *at;
    before_.assign(body.begin(), at);
    after_.assign(at + 1, body.end());
    const Stmt& loop = cx.p.stmts[loop_];
    const auto begin = cx.build.bits_of(loop.value), end = cx.build.bits_of(loop.limit);
    if (begin && end && *end - *begin < fewest_rounds) return false;
    const auto is_other = [](const PassBinding& binding) {
        return binding.atomic || binding.coherent || binding.shape != MemoryShape::buffer;
    };
    if (std::ranges::any_of(cx.pass.bindings, is_other)) return false;
    return is_plain(before_, false) && is_plain(loop.body, false) && is_plain(after_, true);
}

/// Whether the statements may be executed for one element after the other.
bool Lockstep::is_plain(const std::vector<StmtId>& body, bool may_store) {
    return std::ranges::all_of(body, [&](StmtId id) { return is_plain(cx.p.stmts[id], may_store); });
}

bool Lockstep::is_plain(const Stmt& stmt, bool may_store) {
    const bool is_store = stmt.op == StmtOp::store || stmt.op == StmtOp::image_store;
    if (stmt.op != StmtOp::let && stmt.op != StmtOp::assign && stmt.op != StmtOp::if_ && stmt.op != StmtOp::block &&
        !(is_store && may_store))
        return false;
    bool is_pure = true;
    for_each_root(stmt, [&](ExprId root) { is_pure = is_pure && numbers_.is_pure(root); });
    return is_pure && is_plain(stmt.body, may_store) && is_plain(stmt.otherwise, may_store);
}

void Lockstep::learn_before() {
    for (StmtId id : before_) {
        const Stmt& stmt = cx.p.stmts[id];
        if (stmt.op != StmtOp::let || !stmt.value || cx.p.locals[stmt.local].is_mutable) continue;
        if (is_affine(stmt) || is_same(stmt.value)) recompute(id);
    }
}

void Lockstep::recompute(StmtId let) {
    const Stmt& stmt = cx.p.stmts[let];
    if (is_same(stmt.value)) slopes_.learn_steady(stmt.local);
    else slopes_.learn(stmt);
    affine_.push_back(let);
    recomputed_.insert(stmt.local);
    outside_locals_.insert(stmt.local);
}

/// Whether the value changes only with the loop's variable. Loads do not change it: an element stores after the loop.
bool Lockstep::is_stable(ExprId id) {
    bool uses_variables = false;
    for_each_node(cx.p, id, [&](ExprId part) {
        const Expr& node = cx.p.exprs[part];
        uses_variables |= node.op == Op::local && cx.p.locals[node.local].is_mutable;
    });
    return !uses_variables && numbers_.is_pure(id);
}

/// Whether the value of the immutable `let` is a function of the address that advances by a constant along the row, or
/// is constant, and does not load.
bool Lockstep::is_affine(const Stmt& let) {
    if (!is_stable(let.value) || numbers_.has_load(let.value)) return false;
    if (!uses_only(let.value, outside_locals_)) return false;
    const TypeId type = cx.p.locals[let.local].type;
    if (!cx.p.types.is_scalar(type) && !cx.p.types.is_vector(type)) return false;
    const Slopes slopes = slopes_.of(let.value);
    for (std::uint32_t i = 0; i < cx.p.types.components(type); ++i)
        if (!slopes[i].known) return false;
    return true;
}

/// Whether the value uses no other locals than the address and these.
bool Lockstep::uses_only(ExprId id, const IdSet<Local>& locals) const {
    bool uses_others = false;
    for_each_node(cx.p, id, [&](ExprId part) {
        const Expr& node = cx.p.exprs[part];
        uses_others |= node.op == Op::builtin ||
                       (node.op == Op::local && node.local != cx.pass.address && !locals.contains(node.local));
    });
    return !uses_others;
}

/// Whether the value is the same for all elements of a row and can be computed outside of the loop over them.
bool Lockstep::is_same(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (slopes_.is_steady(id) && uses_only(id, outside_locals_)) return true;
    const bool is_operation = node.op == Op::binary || node.op == Op::unary || node.op == Op::construct ||
                              node.op == Op::convert || node.op == Op::swizzle || node.op == Op::index ||
                              node.op == Op::field || node.op == Op::select || node.op == Op::intrinsic;
    const bool is_fixed_load = node.op == Op::load && is_stable(id);
    if (node.operands.empty() || !(is_operation || is_fixed_load)) return false;
    return std::ranges::all_of(node.operands, [&](ExprId operand) { return is_same(operand); });
}

/// The component of a vector, also that of a local that is constructed of its components.
ExprId Lockstep::component(ExprId id, std::uint32_t at) {
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::local)
        if (const ExprId* definition = cx.definitions.find(node.local);
            definition != nullptr && cx.p.exprs[*definition].op == Op::construct)
            return component(*definition, at);
    if (node.op == Op::construct && node.operands.size() == cx.p.types.components(node.type)) return node.operands[at];
    return cx.build.component(id, at);
}

/// Whether a guard, which is a comparison or a conjunction of comparisons, is the same for a run once `cuts` end it.
bool Lockstep::is_same_after_cuts(ExprId id, std::vector<Stmt>& cuts) {
    if (is_same(id)) return true;
    const Expr node = cx.p.exprs[id];
    if (node.op == Op::binary && node.binary == BinaryOp::logical_and)
        return is_same_after_cuts(node.operands[0], cuts) && is_same_after_cuts(node.operands[1], cuts);
    if (node.op == Op::binary && node.binary == BinaryOp::less) return is_component_same(id, 0, cuts);
    if (node.op != Op::intrinsic || node.intrinsic != Intrinsic::all) return false;
    const Expr less = cx.p.exprs[node.operands[0]];
    if (less.op != Op::intrinsic || less.intrinsic != Intrinsic::lessThan) return false;
    for (std::uint32_t i = 0; i < cx.p.types.components(less.type); ++i)
        if (!is_component_same(node.operands[0], i, cuts)) return false;
    return true;
}

bool Lockstep::is_component_same(ExprId less, std::uint32_t at, std::vector<Stmt>& cuts) {
    ExprId left = cx.p.exprs[less].operands[0], right = cx.p.exprs[less].operands[1];
    if (cx.p.types.is_vector(cx.build.type(left))) left = component(left, at);
    if (cx.p.types.is_vector(cx.build.type(right))) right = component(right, at);
    if (is_same(left) && is_same(right)) return true;
    if (cx.build.type(left) != cx.p.types.uint || !slopes_.is_row(left) || !slopes_.is_steady(right)) return false;
    if (!uses_only(left, recomputed_) || !uses_only(right, recomputed_)) return false;
    Stmt cut = statement(StmtOp::cut, cx.p.stmts[loop_].span);
    cut.value = left;
    cut.limit = right;
    cuts.push_back(std::move(cut));
    return true;
}

/// Whether the value may differ from round to round.
bool Lockstep::varies(ExprId id) {
    bool varies = !is_stable(id);
    for_each_node(cx.p, id, [&](ExprId part) { varies = varies || varying_.contains(cx.p.exprs[part].local); });
    return varies;
}

/// Decides where a statement of a round is executed.
void Lockstep::sort(StmtId id) {
    const Stmt& stmt = cx.p.stmts[id];
    if (stmt.op != StmtOp::let || !stmt.value || cx.p.locals[stmt.local].is_mutable) return round_.push_back(id);
    std::vector<Stmt> cuts;
    if (is_same_after_cuts(stmt.value, cuts)) {
        std::ranges::move(cuts, std::back_inserter(cuts_));
        slopes_.learn_steady(stmt.local);
        outside_locals_.insert(stmt.local);
        varying_.insert(stmt.local);
        same_.insert(stmt.local);
        return once_.push_back(id);
    }
    if (is_affine(stmt)) {
        if (!varies(stmt.value)) return recompute(id);
        slopes_.learn(stmt);
        outside_locals_.insert(stmt.local);
        once_.push_back(id);
    } else if (numbers_.has_load(stmt.value) && !varies(stmt.value)) {
        return invariant_.push_back(id);
    }
    varying_.insert(stmt.local);
    round_.push_back(id);
}

/// Adds the bytes of a number, vector or structure; false: it holds arrays.
bool Lockstep::is_small(TypeId type, std::uint32_t& bytes) const {
    const Types& types = cx.p.types;
    if (types.kind(type) == TypeKind::struct_)
        return std::ranges::all_of(cx.p.structs[types[type].struct_].fields,
                                   [&](const StructField& field) { return is_small(field.type, bytes); });
    if (!types.is_scalar(type) && !types.is_vector(type)) return false;
    bytes += 4 * types.components(type);
    return true;
}

/// Finds the locals that are used in other parts than that which declares them. False: they take too much memory.
bool Lockstep::find_kept() {
    std::vector<StmtId> later = invariant_;
    later.insert(later.end(), round_.begin(), round_.end());
    later.insert(later.end(), after_.begin(), after_.end());
    std::vector<StmtId> candidates = before_;
    candidates.insert(candidates.end(), invariant_.begin(), invariant_.end());
    std::uint32_t bytes = 0;
    for (StmtId id : candidates) {
        const Stmt& stmt = cx.p.stmts[id];
        if (stmt.op != StmtOp::let || recomputed_.contains(stmt.local)) continue;
        if (!mentions(cx.p, later, stmt.local)) continue;
        if (!is_small(cx.p.locals[stmt.local].type, bytes)) return false;
        kept_.push_back(stmt.local);
    }
    return bytes <= most_kept_bytes;
}

/// The part of the body, for each element of the run.
StmtId Lockstep::region(const std::vector<StmtId>& body) {
    StatementCopy copy(cx, cx.build.local(cx.pass.address));
    Stmt region = statement(StmtOp::invocations, cx.p.stmts[loop_].span);
    for (StmtId id : affine_) {
        const LocalId local = cx.p.stmts[id].local;
        if (slopes_.is_steady(cx.build.local(local))) copy.replace(local, outside_.of(cx.build.local(local)));
        else region.body.push_back(copy.of(id));
    }
    for (StmtId id : once_)
        if (const LocalId local = cx.p.stmts[id].local; same_.contains(local))
            copy.replace(local, outside_.of(cx.build.local(local)));
    for (StmtId id : body) {
        const Stmt& stmt = cx.p.stmts[id];
        // Locals that are kept stay the same in all parts; others are declared here.
        if (stmt.op != StmtOp::let || std::ranges::find(kept_, stmt.local) == kept_.end()) {
            region.body.push_back(copy.of(id));
            continue;
        }
        Stmt let = stmt;
        let.value = copy.of(let.value);
        region.body.push_back(cx.add(std::move(let)));
    }
    return cx.add(std::move(region));
}

std::vector<StmtId> Lockstep::whole() {
    std::vector<StmtId> result;
    for (StmtId id : affine_) result.push_back(outside_.of(id));
    for (Stmt& cut : cuts_) {
        cut.value = outside_.of(cut.value);
        cut.limit = outside_.of(cut.limit);
        result.push_back(cx.add(std::move(cut)));
    }
    for (LocalId local : kept_) {
        Stmt keep = statement(StmtOp::keep, {});
        keep.local = local;
        result.push_back(cx.add(std::move(keep)));
    }
    Stmt loop = cx.p.stmts[loop_];
    loop.value = outside_.of(loop.value);
    loop.limit = outside_.of(loop.limit);
    std::vector<StmtId> round;
    for (StmtId id : once_) round.push_back(outside_.of(id));
    round.push_back(region(round_));
    loop.body = std::move(round);
    if (!before_.empty()) {
        Stmt first = statement(StmtOp::invocations, loop.span);
        first.body = before_;
        result.push_back(cx.add(std::move(first)));
    }
    if (!invariant_.empty()) {  // what a round loads may be loaded only if there is a round
        Stmt any = statement(StmtOp::if_, loop.span);
        any.value = cx.build.binary(BinaryOp::less, loop.value, loop.limit);
        any.body.push_back(region(invariant_));
        result.push_back(cx.add(std::move(any)));
    }
    result.push_back(cx.add(std::move(loop)));
    result.push_back(region(after_));
    return result;
}

}  // namespace

std::optional<std::vector<StmtId>> in_lockstep(Context& cx, const std::vector<StmtId>& body) {
    return Lockstep(cx).run(body);
}

}  // namespace gliftc::lower
