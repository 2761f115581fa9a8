// A forward data-flow analysis of a kernel's body or a draw's fragment part: where are values and control flow uniform?
// Functions that declare a workgroup (`group`) are analysed at each call, since they may contain barriers. The levels
// in locals_ and exits_ only rise, and the sets of accesses in intervals_ and races_ only grow; the walk is repeated
// until neither changes, then once more to report.
#include "sema/kernels/uniformity.h"

#include "ir/effects.h"
#include "ir/walk.h"

#include <map>
#include <set>
#include <utility>

namespace gliftc::sema {

namespace {

/// The largest scope in which a value is the same for all invocations; `invocation`: it is divergent.
enum class Level : std::uint8_t { workgroup, subgroup, invocation };

/// The uniformity of a value or of the control flow to a statement.
struct Flow {
    Level level = Level::workgroup;
    Span why;        ///< the expression that is divergent
    Span condition;  ///< control flow: the condition or loop bound that is divergent
};

Flow worse(const Flow& one, const Flow& other) { return other.level > one.level ? other : one; }

/// A call of a function with a workgroup, analysed separately with its own locals; the kernel is call 0.
using Call = std::uint32_t;

/// Accesses to workgroup memory since the last barrier.
struct Interval {
    std::set<ir::LocalId> written;
    std::set<std::pair<ir::LocalId, ir::ExprId>> read;

    bool add(const Interval& other) {
        const std::size_t before = written.size() + read.size();
        written.insert(other.written.begin(), other.written.end());
        read.insert(other.read.begin(), other.read.end());
        return written.size() + read.size() != before;
    }
};

class Uniformity {
public:
    Uniformity(Context& context, const ir::Kernel& kernel) : c(context), p(context.program), kernel_(kernel) {
        for (std::uint32_t i = 0; i < kernel.params.size(); ++i) roots_.push_back(i);
    }

    void run(const std::vector<ir::StmtId>& body) {
        do {
            changed_ = false;
            start(body);
        } while (changed_);
        reports_ = true;
        start(body);
    }

private:
    void start(const std::vector<ir::StmtId>& body) {
        interval_ = {};
        left_ = {};
        walk(body);
    }
    void walk(const std::vector<ir::StmtId>& body) {
        for (ir::StmtId id : body) visit(id);
    }
    void visit(ir::StmtId id);
    void if_(const ir::Stmt& stmt);
    void loop_(ir::StmtId id);
    void assign(const ir::Stmt& stmt);
    void barrier(const ir::Stmt& stmt, Level allowed);

    Flow value(ir::ExprId id);
    Flow operands(const ir::Expr& node);
    Flow local(ir::ExprId id, const ir::Expr& node);
    Flow intrinsic(const ir::Expr& node);
    Flow choice(const ir::Expr& node);
    Flow varying(ir::LocalId local) const;
    void derivative(const ir::Expr& node);
    void leave() { left_ = worse(left_, control_flow_); }
    Flow call(ir::ExprId id, const ir::Expr& node);
    Flow grouped_call(ir::ExprId id, const ir::Expr& node);
    Flow invocation(const ir::Expr& node) const;
    Flow of_memory(const ir::Expr& node, const ir::Place& place, const Flow& address) const;

    void raise(Flow& flow, const Flow& to) {
        if (to.level <= flow.level) return;
        flow = to;
        changed_ = true;
    }
    void write_shared(ir::LocalId local);
    static Flow differs(const ir::Expr& node, Level level = Level::invocation) { return {level, node.span, {}}; }

    Context& c;
    const ir::Program& p;
    const ir::Kernel& kernel_;
    std::map<std::pair<Call, ir::LocalId>, Flow> locals_;
    std::map<std::pair<Call, ir::StmtId>, Flow> exits_;  ///< for each loop: control flow to its breaks and continues
    std::map<std::pair<Call, ir::StmtId>, Interval> intervals_;  ///< for each loop: accesses at the end of its body
    std::map<std::pair<Call, ir::ExprId>, Call> calls_;
    std::set<std::pair<ir::LocalId, ir::ExprId>> races_;          ///< reads of workgroup memory that race with a write
    std::set<std::pair<std::uint32_t, std::uint32_t>> reported_;  ///< file and offset of what was reported

    Call call_ = 0;
    std::vector<std::uint32_t> roots_;  ///< the kernel's parameter behind each Place root
    Flow control_flow_;
    Flow left_;  ///< control flow to the returns and discards so far: invocations that took them are missing afterwards
    Flow result_;
    Flow* exit_ = nullptr;  ///< the innermost loop's entry of exits_
    Interval interval_;
    bool changed_ = false, reports_ = false;
};

void Uniformity::visit(ir::StmtId id) {
    const ir::Stmt& stmt = p.stmts[id];
    switch (stmt.op) {
    case ir::StmtOp::let:
        if (stmt.value) raise(locals_[{call_, stmt.local}], value(stmt.value));
        return;
    case ir::StmtOp::assign: return assign(stmt);
    case ir::StmtOp::if_: return if_(stmt);
    case ir::StmtOp::for_:
    case ir::StmtOp::while_: return loop_(id);
    case ir::StmtOp::break_:
    case ir::StmtOp::continue_: return raise(*exit_, control_flow_);
    case ir::StmtOp::return_:
        if (stmt.value) result_ = value(stmt.value);
        return leave();
    case ir::StmtOp::discard: return leave();
    case ir::StmtOp::barrier: return barrier(stmt, Level::workgroup);
    case ir::StmtOp::subgroup_barrier: return barrier(stmt, Level::subgroup);
    default: break;  // below: its expressions and nested statements
    }
    ir::for_each_root(stmt, [&](ir::ExprId root) { value(root); });
    walk(stmt.body);
}

void Uniformity::if_(const ir::Stmt& stmt) {
    const Flow condition = value(stmt.value), before = control_flow_;
    control_flow_ = worse(control_flow_, {condition.level, condition.why, p.exprs[stmt.value].span});
    Interval otherwise = interval_;
    walk(stmt.body);
    std::swap(interval_, otherwise);
    walk(stmt.otherwise);
    interval_.add(otherwise);
    control_flow_ = before;
}

/// Control flow in a loop's body depends on its bounds or condition, and on its breaks and continues.
void Uniformity::loop_(ir::StmtId id) {
    const ir::Stmt& stmt = p.stmts[id];
    const Flow before = control_flow_;
    Flow* const outer = exit_;
    Flow& exit = exits_[{call_, id}];
    Interval& last = intervals_[{call_, id}];
    exit_ = &exit;
    interval_.add(last);
    const auto leaves = [&](const ir::Stmt& inner) {
        return inner.op == ir::StmtOp::discard || inner.op == ir::StmtOp::return_;
    };
    bool may_leave = false;
    ir::for_each_statement(p, stmt.body, [&](const ir::Stmt& inner) { may_leave = may_leave || leaves(inner); });
    for (ir::ExprId bound : {stmt.value, stmt.limit}) {
        if (!bound) continue;
        const Flow flow = value(bound);
        control_flow_ = worse(control_flow_, {flow.level, flow.why, p.exprs[bound].span});
        if (stmt.op == ir::StmtOp::for_ && bound == stmt.value) raise(locals_[{call_, stmt.local}], flow);
    }
    control_flow_ = worse(control_flow_, exit);
    if (stmt.op == ir::StmtOp::while_) value(stmt.value);  // again, in the control flow after breaks and continues
    const Interval entry = interval_;
    const bool reports = std::exchange(reports_, false);
    if (may_leave) walk(stmt.body);  // an invocation that leaves in one round is missing from the start of the next
    reports_ = reports;
    walk(stmt.body);
    if (last.add(interval_)) changed_ = true;
    interval_.add(entry);
    exit_ = outer;
    control_flow_ = before;
}

void Uniformity::assign(const ir::Stmt& stmt) {
    Flow flow = worse(value(stmt.value), control_flow_);
    ir::ExprId root = stmt.target;
    for (; p.exprs[root].op != ir::Op::local; root = p.exprs[root].operands[0])
        if (p.exprs[root].op == ir::Op::index) flow = worse(flow, value(p.exprs[root].operands[1]));
    const ir::LocalId target = p.exprs[root].local;
    if (p.locals[target].storage == ir::Storage::shared) write_shared(target);
    else raise(locals_[{call_, target}], flow);
}

void Uniformity::write_shared(ir::LocalId local) {
    interval_.written.insert(local);
    for (const auto& read : interval_.read)
        if (read.first == local && races_.insert(read).second) changed_ = true;
}

void Uniformity::barrier(const ir::Stmt& stmt, Level allowed) {
    if (allowed == Level::workgroup) interval_ = {};
    if (!reports_ || control_flow_.level <= allowed || !reported_.insert({stmt.span.file, stmt.span.begin}).second)
        return;
    const bool of_workgroup = allowed == Level::workgroup;
    const char* const barrier = of_workgroup ? "barrier" : "subgroupBarrier";
    Diagnostic& diagnostic =
        c.error(Diag::divergent_barrier, stmt.span, {barrier, of_workgroup ? "workgroup" : "subgroup"});
    note(diagnostic, control_flow_.condition, "this may differ between them");
    if (control_flow_.why != control_flow_.condition) note(diagnostic, control_flow_.why, "because this does");
    note(diagnostic, stmt.span, "put the barrier outside, and the condition around the code before and after it");
}

Flow Uniformity::value(ir::ExprId id) {
    const ir::Expr& node = p.exprs[id];
    switch (node.op) {
    case ir::Op::local: return local(id, node);
    case ir::Op::element:
    case ir::Op::address:
    case ir::Op::near:
    case ir::Op::window:
    case ir::Op::position: return operands(node), differs(node);
    case ir::Op::front_facing: return differs(node, Level::subgroup);
    case ir::Op::select: return choice(node);
    case ir::Op::binary:
        if (node.binary == ir::BinaryOp::logical_and || node.binary == ir::BinaryOp::logical_or) return choice(node);
        return operands(node);
    case ir::Op::invocation: return invocation(node);
    case ir::Op::read:
    case ir::Op::sample:
    case ir::Op::gather:
    case ir::Op::compare:
    case ir::Op::translate: return of_memory(node, node.place, operands(node));
    case ir::Op::intrinsic: return intrinsic(node);
    case ir::Op::call: return call(id, node);
    default: return operands(node);
    }
}

/// `?:`, `select`, `&&`, `||`: the first operand decides which of the others are evaluated.
Flow Uniformity::choice(const ir::Expr& node) {
    Flow flow = value(node.operands[0]);
    const Flow before = control_flow_;
    control_flow_ = worse(control_flow_, {flow.level, flow.why, p.exprs[node.operands[0]].span});
    for (std::size_t i = 1; i < node.operands.size(); ++i) flow = worse(flow, value(node.operands[i]));
    control_flow_ = before;
    return flow;
}

/// Varyings differ between the fragments of a quad, except flat ones, which have the value of the primitive's first
/// vertex.
Flow Uniformity::varying(ir::LocalId local) const {
    if (!kernel_.raster) return {};
    for (const ir::Varying& varying : kernel_.raster->varyings)
        if (varying.read == local)
            return {varying.interpolation == ir::Interpolation::flat ? Level::subgroup : Level::invocation,
                    varying.span,
                    {}};
    return {};
}

/// Derivatives need control flow that is uniform within a quad. The level of flat varyings (subgroup) is enough: all
/// fragments of a quad belong to one primitive.
void Uniformity::derivative(const ir::Expr& node) {
    const Flow flow = worse(control_flow_, left_);
    if (!reports_ || flow.level <= Level::subgroup || !reported_.insert({node.span.file, node.span.begin}).second)
        return;
    Diagnostic& diagnostic = c.error(Diag::divergent_derivative, node.span, {ir::name_of(node.intrinsic)});
    note(diagnostic, flow.condition, "this may differ between them");
    if (flow.why != flow.condition) note(diagnostic, flow.why, "because this does");
    note(diagnostic, node.span, "compute it in a local before the condition");
}

Flow Uniformity::operands(const ir::Expr& node) {
    Flow flow;
    for (ir::ExprId operand : node.operands) flow = worse(flow, value(operand));
    return flow;
}

/// A local's value. A read of workgroup memory is uniform if no invocation writes that array between the barriers
/// before and after the read.
Flow Uniformity::local(ir::ExprId id, const ir::Expr& node) {
    if (p.locals[node.local].storage != ir::Storage::shared)
        return worse(locals_[{call_, node.local}], varying(node.local));
    interval_.read.insert({node.local, id});
    if (interval_.written.contains(node.local) || races_.contains({node.local, id})) return differs(node);
    return {};
}

Flow Uniformity::invocation(const ir::Expr& node) const {
    switch (node.invocation) {
    case ir::Invocation::local_index:
    case ir::Invocation::subgroup_lane: return differs(node);
    case ir::Invocation::subgroup_index: return differs(node, Level::subgroup);
    case ir::Invocation::group_index:
    case ir::Invocation::group_count:
    case ir::Invocation::group_size:
    case ir::Invocation::subgroup_size:
    case ir::Invocation::subgroup_count: break;
    }
    return {};
}

/// A read through an `any` parameter, whose elements the pass does not write, is uniform if its address is; no other
/// read is.
Flow Uniformity::of_memory(const ir::Expr& node, const ir::Place& place, const Flow& address) const {
    const ir::KernelParam& param = kernel_.params[roots_[place.root]];
    const bool is_fixed =
        param.direction == ir::Direction::in && ir::traits_of(param.pattern).reach == ir::Reach::anywhere;
    return is_fixed ? address : differs(node);
}

Flow Uniformity::intrinsic(const ir::Expr& node) {
    const std::string_view signature = ir::signature_of(node.intrinsic);
    if (signature[0] == '@') {
        ir::ExprId root = node.operands[0];
        while (p.exprs[root].op == ir::Op::index || p.exprs[root].op == ir::Op::field) root = p.exprs[root].operands[0];
        if (p.exprs[root].op == ir::Op::local) write_shared(p.exprs[root].local);
    }
    const Flow flow = operands(node);
    if (ir::is_derivative(node.intrinsic)) {
        derivative(node);
        return flow;
    }
    if (signature[0] == '@') return differs(node);
    if (signature.back() != '*') return flow;
    switch (node.intrinsic) {
    case ir::Intrinsic::subgroupMin:
    case ir::Intrinsic::subgroupMax:
    case ir::Intrinsic::subgroupAnd:
    case ir::Intrinsic::subgroupOr:
    case ir::Intrinsic::subgroupAll:
    case ir::Intrinsic::subgroupAny:
    case ir::Intrinsic::subgroupBroadcast:
    case ir::Intrinsic::subgroupBroadcastFirst:
        return flow.level == Level::workgroup ? flow : differs(node, Level::subgroup);
    case ir::Intrinsic::subgroupAdd:  // these five depend on the number of active lanes, which differs by subgroup
    case ir::Intrinsic::subgroupMul:
    case ir::Intrinsic::subgroupXor:
    case ir::Intrinsic::subgroupBallot:
    case ir::Intrinsic::subgroupBallotCount: return differs(node, Level::subgroup);
    default: return differs(node);
    }
}

/// The result of a function without a workgroup is uniform if its arguments and all that it reads are.
Flow Uniformity::call(ir::ExprId id, const ir::Expr& node) {
    if (p.functions[node.function].grouped()) return grouped_call(id, node);
    Flow flow = operands(node);
    for (const ir::Place& place : node.places) flow = worse(flow, of_memory(node, place, {}));
    return flow;
}

Flow Uniformity::grouped_call(ir::ExprId id, const ir::Expr& node) {
    const ir::Function& function = p.functions[node.function];
    const Call made = calls_.try_emplace({call_, id}, static_cast<Call>(calls_.size() + 1)).first->second;
    for (std::size_t i = 0; i < node.operands.size(); ++i)
        raise(locals_[{made, function.params[i]}], value(node.operands[i]));
    std::vector<std::uint32_t> roots;
    for (const ir::Place& place : node.places) roots.push_back(roots_[place.root]);
    std::swap(roots, roots_);
    const Call outer = std::exchange(call_, made);
    Flow* const outer_exit = std::exchange(exit_, nullptr);
    const Flow outer_result = std::exchange(result_, {});
    walk(function.body);
    call_ = outer;
    exit_ = outer_exit;
    std::swap(roots, roots_);
    return std::exchange(result_, outer_result);
}

}  // namespace

void check_barriers(Context& c, const ir::Kernel& kernel) { Uniformity(c, kernel).run(kernel.body); }

void check_derivatives(Context& c, const ir::Kernel& kernel) { Uniformity(c, kernel).run(kernel.raster->fragment); }

}  // namespace gliftc::sema
