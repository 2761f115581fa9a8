#include "lower/transform/share.h"

#include "ir/walk.h"
#include "lower/analysis/number.h"

#include <algorithm>
#include <utility>

namespace gliftc::lower {

using namespace ir;

namespace {

/// A value that may be used more than once.
struct Record {
    std::uint32_t uses = 0;
    LocalId local;        ///< the local that holds it, once it is declared
    Name name;            ///< the name that the source gives it, if any
    bool is_let = false;  ///< the body has a `let` of it
};

/// What is done with an expression or a `let` that the walk comes to.
struct Decision {
    enum Kind : std::uint8_t {
        operands,  // keep the node; its operands have decisions of their own
        truth,     // replace a condition whose value is known: by true if `number` is 1, by false if it is 0
        first,     // first use of the value of record `number`
        repeated,  // replace by the local of record `number`
        renamed,   // drop a `let` whose value is another local: uses name that local
        any,       // keep a `let`; its value has a decision of its own
    };
    Kind kind = operands;
    std::uint32_t number = 0;
};

struct Plan {
    std::vector<Record> records;
    std::vector<Decision> decisions;  ///< in the order of the walk
};

/// Whether the first operand is a location in memory, not a value: in atomic operations.
bool names_place(const Expr& node) { return node.op == Op::intrinsic && signature_of(node.intrinsic)[0] == '@'; }

/// The first walk over a body: counts the uses of each value, and makes the Decisions for the second walk.
class Counting {
public:
    Counting(Context& context, const std::vector<ExprId>& facts, Plan& plan)
        : cx(context), numbers_(context), plan_(plan) {
        undo_.reserve(64);
        available_.reserve(256);
        for (ExprId fact : facts) assume(numbers_.of(fact), true);
    }

    void run(const std::vector<StmtId>& body) {
        const std::size_t outer = undo_.size();
        for (StmtId id : body) statement_(id);
        for (; undo_.size() > outer; undo_.pop_back()) available_[undo_.back().first] = undo_.back().second;
    }

private:
    enum class Where { before, conditional, loop_condition };

    void statement_(StmtId id);
    void let_(const Stmt& stmt);
    void loop_(const Stmt& stmt);
    void visit(ExprId id, Where where);
    void visit_operands(const Expr& node, Where where);
    void visit_target(ExprId id);
    void begin_record(ValueNumber number);
    std::uint32_t& available(ValueNumber number) {
        if (number >= available_.size())
            available_.resize(std::max<std::size_t>(number + 1, available_.size() * 2), none);
        return available_[number];
    }
    void decide(Decision::Kind kind, std::uint32_t number = 0) { plan_.decisions.push_back({kind, number}); }
    void run_knowing(const std::vector<StmtId>& body, ExprId condition, bool holds);
    bool assume(ValueNumber number, bool holds);
    const bool* known(ExprId id, const Expr& node);
    bool is_leaf(ExprId id, const Expr& node);
    Name name_in_source(ExprId id) const;

    Context& cx;
    Numbers numbers_;
    Plan& plan_;
    static constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> available_;  ///< for each value number the index of the record in scope, or `none`
    std::vector<std::pair<ValueNumber, std::uint32_t>> undo_;
    std::vector<std::pair<ValueNumber, bool>> known_;  ///< conditions that are known to be true or false
};

void Counting::begin_record(ValueNumber number) {
    const auto record = static_cast<std::uint32_t>(plan_.records.size());
    plan_.records.emplace_back().uses = 1;
    undo_.emplace_back(number, available(number));
    available_[number] = record;
    decide(Decision::first, record);
}

/// Whether the expression needs no local: it is short, or uniform.
bool Counting::is_leaf(ExprId id, const Expr& node) {
    if (node.op == Op::local || is_trivial(cx, id)) return true;
    if (node.op == Op::swizzle || node.op == Op::field) return is_leaf(node.operands[0], cx.p.exprs[node.operands[0]]);
    // Uniform values will be parameters.
    return is_uniform(cx, id);
}

Name Counting::name_in_source(ExprId id) const {
    const Name* found = cx.names.find(id);
    return found == nullptr ? Name{} : *found;
}

/// Notes that a condition holds or does not; false if it was known already.
bool Counting::assume(ValueNumber number, bool holds) {
    for (const auto& [known, value] : known_)
        if (known == number) return false;
    known_.emplace_back(number, holds);
    return true;
}

/// Walks a body in which the condition is known to hold, or known not to. Not noted is a constant, or a condition that
/// may change while the kernel runs (Numbers::is_fixed).
void Counting::run_knowing(const std::vector<StmtId>& body, ExprId condition, bool holds) {
    if (body.empty()) return;
    const bool is_new =
        numbers_.is_fixed(condition) && !cx.build.is_constant(condition) && assume(numbers_.of(condition), holds);
    run(body);
    if (is_new) known_.pop_back();
}

const bool* Counting::known(ExprId id, const Expr& node) {
    if (node.type != cx.p.types.bool_ || known_.empty() || node.op == Op::constant || !numbers_.is_fixed(id))
        return nullptr;
    const ValueNumber number = numbers_.of(id);
    for (const auto& [known, holds] : known_)
        if (known == number) return &holds;
    return nullptr;
}

void Counting::visit(ExprId id, Where where) {
    const Expr& node = cx.p.exprs[id];
    if (const bool* holds = known(id, node)) return decide(Decision::truth, *holds);
    if (!is_leaf(id, node) && numbers_.is_pure(id)) {
        const ValueNumber number = numbers_.of(id);
        if (const std::uint32_t found = available(number); found != none) {
            ++plan_.records[found].uses;
            return decide(Decision::repeated, found);
        }
        // A local is declared before the statement, so its value is computed once and unconditionally. This is not
        // allowed for a load under a condition, whose address may be invalid, nor for values in the condition of a
        // while loop, which are computed anew for each iteration.
        if (where == Where::before || (where == Where::conditional && !numbers_.has_load(id))) {
            begin_record(number);
            plan_.records.back().name = name_in_source(id);
            return visit_operands(node, where);
        }
    }
    decide(Decision::operands);
    visit_operands(node, where);
}

void Counting::visit_operands(const Expr& node, Where where) {
    const Where then = where == Where::before ? Where::conditional : where;
    const bool is_logical =
        node.op == Op::binary && (node.binary == BinaryOp::logical_and || node.binary == BinaryOp::logical_or);
    for (std::size_t i = 0; i < node.operands.size(); ++i) {
        const bool may_skip = i > 0 && (node.op == Op::select || node.op == Op::guarded_load || is_logical);
        if (i == 0 && names_place(node)) visit_target(node.operands[0]);
        else visit(node.operands[i], may_skip ? then : where);
    }
}

void Counting::visit_target(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::local) return;
    if (node.op == Op::load || node.op == Op::image_load) visit(node.operands[0], Where::before);
    else visit_target(node.operands[0]);
    if (node.op == Op::index) visit(node.operands[1], Where::before);
}

/// Drops a `let` whose value was computed before: uses then name the local of the earlier one. Otherwise later uses of
/// the value name the local of this `let`, unless the value needs no local (is_leaf). A condition that is known to
/// hold, or not to, becomes a constant. The `let` of a mutable local, or of a value that is not pure (number.h), stays.
void Counting::let_(const Stmt& stmt) {
    const Local& local = cx.p.locals[stmt.local];
    if (!stmt.value || local.is_mutable || !numbers_.is_pure(stmt.value)) {
        decide(Decision::any);
        if (stmt.value) visit(stmt.value, Where::before);
        return numbers_.change_all(stmt);  // an atomic operation changes workgroup memory
    }
    const Expr& value = cx.p.exprs[stmt.value];
    const ValueNumber number = numbers_.of(stmt.value);
    if (const bool* holds = known(stmt.value, value)) {
        decide(Decision::truth, *holds);
    } else if (value.op == Op::local && !cx.p.locals[value.local].is_mutable) {
        decide(Decision::renamed);
    } else if (const std::uint32_t found = available(number); found != none) {
        Record& record = plan_.records[found];
        ++record.uses;
        if (!record.is_let) record.name = local.name, record.is_let = true;
        decide(Decision::repeated, found);
    } else if (is_leaf(stmt.value, value)) {
        decide(Decision::operands);
        numbers_.define(stmt.local, number);
        return visit_operands(value, Where::before);
    } else {
        begin_record(number);
        plan_.records.back().is_let = true;
        visit_operands(value, Where::before);
    }
    numbers_.define(stmt.local, number);
}

void Counting::loop_(const Stmt& stmt) {
    if (stmt.op == StmtOp::for_) {
        visit(stmt.value, Where::before);
        visit(stmt.limit, Where::before);
        numbers_.change_all(stmt.body);
    } else {
        numbers_.change_all(stmt.body);
        visit(stmt.value, Where::loop_condition);
    }
    run(stmt.body);
    numbers_.change_all(stmt.body);
}

void Counting::statement_(StmtId id) {
    const Stmt& stmt = cx.p.stmts[id];
    if (stmt.op == StmtOp::let) return let_(stmt);
    if (stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_) return loop_(stmt);
    // First the statement's expressions, then the statements inside it, then what it changes.
    if (stmt.value) visit(stmt.value, Where::before);
    if (stmt.target && stmt.op == StmtOp::assign) visit_target(stmt.target);
    else if (stmt.target) visit(stmt.target, Where::before);
    if (stmt.op == StmtOp::if_) {
        run_knowing(stmt.body, stmt.value, true);
        run_knowing(stmt.otherwise, stmt.value, false);
    } else {
        run(stmt.body);
        run(stmt.otherwise);
    }
    numbers_.change_all(stmt);
}

/// The second walk, in the same order: does what was decided.
class Rewriting {
public:
    Rewriting(Context& context, Plan& plan) : cx(context), plan_(plan), next_(plan.decisions.data()) {}

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        result.reserve(body.size());
        std::vector<StmtId>* outer = std::exchange(out_, &result);
        for (StmtId id : body) statement_(id);
        out_ = outer;
        return result;
    }

private:
    void statement_(StmtId id);
    void let_(StmtId id);
    ExprId visit(ExprId id);
    ExprId visit_operands(ExprId id);
    ExprId visit_target(ExprId id);
    ExprId visit_first(ExprId id, Record& record);
    LocalId renamed(LocalId local) const {
        const LocalId* found = renamed_.find(local);
        return found == nullptr ? local : *found;
    }
    void append(StmtId id, Builder::Parts parts) { out_->push_back(cx.build.again(id, std::move(parts))); }
    Name made_name(const Expr& node);

    Context& cx;
    Plan& plan_;
    const Decision* next_;
    NodeMap<LocalId, LocalId> renamed_{cx.first_local};
    std::vector<StmtId>* out_ = nullptr;
    Span span_;
};

Name Rewriting::made_name(const Expr& node) {
    const auto name = [&](std::string_view text) { return cx.p.names->intern(text); };
    if (node.op == Op::load || node.op == Op::image_load) return name(cx.pass.bindings[node.slot].name + "_value");
    if (node.op == Op::call) return name((*cx.p.names)[cx.p.functions[node.function].name] + "_result");
    return name(node.type == cx.p.types.bool_ ? "test" : "value");
}

ExprId Rewriting::visit(ExprId id) {
    const Decision decision = *next_++;
    if (decision.kind == Decision::truth) return cx.build.truth(decision.number != 0);
    if (decision.kind == Decision::repeated) return cx.build.local(plan_.records[decision.number].local);
    if (decision.kind == Decision::first) return visit_first(id, plan_.records[decision.number]);
    const Expr& node = cx.p.exprs[id];
    if (node.op != Op::local) return visit_operands(id);
    const LocalId local = renamed(node.local);
    return local == node.local ? id : cx.build.local(local);
}

/// The first use of a value: makes a local of it if there are more uses.
ExprId Rewriting::visit_first(ExprId id, Record& record) {
    const ExprId value = visit_operands(id);
    if (record.uses < 2) return value;
    const Expr& node = cx.p.exprs[id];
    record.local = cx.new_local(record.name ? record.name : made_name(node), node.type, span_);
    cx.definitions[record.local] = value;
    cx.p.locals[record.local].is_temporary = true;
    Stmt stmt = statement(StmtOp::let, span_);
    stmt.local = record.local;
    stmt.value = value;
    out_->push_back(cx.add(std::move(stmt)));
    return cx.build.local(record.local);
}

ExprId Rewriting::visit_operands(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (node.operands.empty()) return id;
    Operands operands;
    for (std::size_t i = 0; i < node.operands.size(); ++i)
        operands.push_back(i == 0 && names_place(node) ? visit_target(node.operands[i]) : visit(node.operands[i]));
    if (operands == node.operands) return id;
    const ExprId result = cx.build.again(node, std::move(operands));
    if (const Name* found = cx.names.find(id)) {
        const Name name = *found;
        cx.names.emplace(result, name);
    }
    return result;
}

ExprId Rewriting::visit_target(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::local) return id;
    Expr copy = node;
    copy.operands[0] =
        node.op == Op::load || node.op == Op::image_load ? visit(node.operands[0]) : visit_target(node.operands[0]);
    if (node.op == Op::index) copy.operands[1] = visit(node.operands[1]);
    return cx.p.exprs.add(std::move(copy));
}

void Rewriting::let_(StmtId id) {
    const Stmt& stmt = cx.p.stmts[id];
    const Decision decision = *next_++;
    Builder::Parts parts;
    switch (decision.kind) {
    case Decision::renamed: renamed_[stmt.local] = renamed(cx.p.exprs[stmt.value].local); return;
    case Decision::repeated: renamed_[stmt.local] = plan_.records[decision.number].local; return;
    case Decision::truth: parts.value = cx.build.truth(decision.number != 0); break;
    case Decision::first:
        parts.value = visit_operands(stmt.value);
        cx.definitions[stmt.local] = parts.value;
        plan_.records[decision.number].local = stmt.local;
        break;
    case Decision::operands: parts.value = visit_operands(stmt.value); break;
    case Decision::any:
        if (stmt.value) parts.value = visit(stmt.value);
        break;
    }
    append(id, std::move(parts));
}

void Rewriting::statement_(StmtId id) {
    const Stmt& stmt = cx.p.stmts[id];
    span_ = stmt.span;
    if (stmt.op == StmtOp::let) return let_(id);
    Builder::Parts parts{{}, {}, stmt.limit, {}, {}};
    if (stmt.value) parts.value = visit(stmt.value);
    if (stmt.op == StmtOp::for_) parts.limit = visit(stmt.limit);
    if (stmt.target) parts.target = stmt.op == StmtOp::assign ? visit_target(stmt.target) : visit(stmt.target);
    parts.body = run(stmt.body);
    parts.otherwise = run(stmt.otherwise);
    append(id, std::move(parts));
}

}  // namespace

std::vector<StmtId> share(Context& cx, const std::vector<StmtId>& body, const std::vector<ExprId>& facts) {
    Plan plan;
    plan.records.reserve(64);
    plan.decisions.reserve(512);
    Counting(cx, facts, plan).run(body);
    return Rewriting(cx, plan).run(body);
}

}  // namespace gliftc::lower
