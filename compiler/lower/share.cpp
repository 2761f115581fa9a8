#include "lower/share.h"

#include "ir/walk.h"
#include "lower/number.h"

#include <algorithm>
#include <optional>

namespace gliftc::lower {

using namespace ir;

namespace {

/// One value that may be used more than once.
struct Record {
    std::uint32_t uses = 0;
    LocalId local;        ///< that holds it, once it is declared
    Name name;            ///< that the source gave it, if any
    bool is_let = false;  ///< the source gives it a local
};

/// Walks a body twice in the same way: first counting, then rewriting. Records are told apart by the order in which
/// they are made, which is the same in both walks.
class Sharing {
public:
    Sharing(Context& context, Numbers& numbers, std::vector<Record>& records, const std::vector<ExprId>& facts,
            bool rewrites)
        : cx(context), numbers_(numbers), records_(records), rewrites_(rewrites) {
        undo_.reserve(64);
        available_.reserve(256);
        for (ExprId fact : facts) known_.emplace(numbers_.of(fact), true);
    }

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        if (rewrites_) result.reserve(body.size());
        Scope scope{*this};
        std::vector<StmtId>* outer = out_;
        out_ = &result;
        for (StmtId id : body) statement_(id);
        out_ = outer;
        return result;
    }

private:
    enum class Where { before, conditional, loop_condition };

    struct Scope {
        explicit Scope(Sharing& owner) : owner(owner), size(owner.undo_.size()) {}
        ~Scope() {
            while (owner.undo_.size() > size) {
                auto& [number, previous] = owner.undo_.back();
                owner.available_[number] = previous;
                owner.undo_.pop_back();
            }
        }
        Sharing& owner;
        std::size_t size;
    };

    void statement_(StmtId id);
    void let_(StmtId id);
    void loop_(StmtId id);
    ExprId visit(ExprId id, Where where);
    ExprId visit_operand(const Expr& node, std::size_t i, Where where);
    ExprId visit_operands(ExprId id, Where where);
    ExprId visit_target(ExprId id, Where where);
    std::uint32_t new_record(ValueNumber number);
    std::uint32_t& available(ValueNumber number) {
        if (number >= available_.size())
            available_.resize(std::max<std::size_t>(number + 1, available_.size() * 2), none);
        return available_[number];
    }
    void append(Stmt stmt) { out_->push_back(cx.add(std::move(stmt))); }
    void append(StmtId id, Make::Parts parts) {
        if (rewrites_) out_->push_back(cx.make.again(id, std::move(parts)));
    }
    std::vector<StmtId> run_knowing(const std::vector<StmtId>& body, ExprId condition, bool holds);
    std::optional<bool> known(ExprId id);
    bool is_leaf(ExprId id);
    Name name_in_source(ExprId id) const;
    Name made_name(ExprId id);

    Context& cx;
    Numbers& numbers_;
    std::vector<Record>& records_;
    bool rewrites_;
    std::uint32_t made_ = 0;
    static constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> available_;  ///< the record of each number in scope, or none
    std::vector<std::pair<ValueNumber, std::uint32_t>> undo_;
    NodeMap<LocalId, LocalId> renamed_{cx.first_local};
    std::unordered_map<ValueNumber, bool> known_;  ///< conditions that are decided here
    std::vector<StmtId>* out_ = nullptr;
    Span span_;
};

std::uint32_t Sharing::new_record(ValueNumber number) {
    std::uint32_t record = made_++;
    if (record == records_.size()) records_.emplace_back();
    undo_.emplace_back(number, available(number));
    available_[number] = record;
    return record;
}

/// What is as short as a name.
bool Sharing::is_leaf(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::local || is_trivial(cx, id)) return true;
    if (node.op == Op::swizzle || node.op == Op::field) return is_leaf(node.operands[0]);
    // Uniform values become parameters.
    return is_uniform(cx, id);
}

Name Sharing::name_in_source(ExprId id) const {
    const Name* found = cx.names.find(id);
    return found == nullptr ? Name{} : *found;
}

Name Sharing::made_name(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    const auto name = [&](std::string_view text) { return cx.p.names->intern(text); };
    if (node.op == Op::load || node.op == Op::image_load) return name(cx.pass.bindings[node.slot].name + "_value");
    if (node.op == Op::call) return name((*cx.p.names)[cx.p.functions[node.function].name] + "_result");
    return name(node.type == cx.p.types.bool_ ? "test" : "value");
}

/// A body where the condition is known. What may change within the body is not.
std::vector<StmtId> Sharing::run_knowing(const std::vector<StmtId>& body, ExprId condition, bool holds) {
    if (!numbers_.is_fixed(condition) || cx.make.is_constant(condition)) return run(body);
    auto [added, is_new] = known_.emplace(numbers_.of(condition), holds);
    ValueNumber number = added->first;
    std::vector<StmtId> result = run(body);
    if (is_new) known_.erase(number);
    return result;
}

std::optional<bool> Sharing::known(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (known_.empty() || node.type != cx.p.types.bool_ || node.op == Op::constant || !numbers_.is_fixed(id))
        return std::nullopt;
    auto found = known_.find(numbers_.of(id));
    return found == known_.end() ? std::nullopt : std::optional(found->second);
}

ExprId Sharing::visit(ExprId id, Where where) {
    const Expr& node = cx.p.exprs[id];
    if (auto decided = known(id)) return rewrites_ ? cx.make.truth(*decided) : id;
    if (node.op == Op::local) {
        const LocalId* found = renamed_.find(node.local);
        return found == nullptr || !rewrites_ ? id : cx.make.local(*found);
    }
    if (is_leaf(id) || !numbers_.is_pure(id)) return visit_operands(id, where);
    if (where != Where::before && numbers_.has_load(id)) return visit_operands(id, where);
    ValueNumber number = numbers_.of(id);
    if (std::uint32_t found = available(number); found != none) {
        Record& record = records_[found];
        ++record.uses;
        if (rewrites_ && record.local) return cx.make.local(record.local);
        if (!rewrites_) return id;
        return visit_operands(id, where);
    }
    if (where == Where::loop_condition) return visit_operands(id, where);
    std::uint32_t index = new_record(number);
    if (!rewrites_) {
        records_[index].uses = 1;
        records_[index].name = name_in_source(id);
        return visit_operands(id, where);
    }
    ExprId value = visit_operands(id, where);
    Record& record = records_[index];
    if (record.uses < 2) return value;
    record.local = cx.new_local(record.name ? record.name : made_name(id), node.type, span_);
    cx.definitions[record.local] = value;
    cx.made.insert(record.local);
    numbers_.define(record.local, number);
    Stmt stmt = statement(StmtOp::let, span_);
    stmt.local = record.local;
    stmt.value = value;
    append(std::move(stmt));
    return cx.make.local(record.local);
}

ExprId Sharing::visit_operand(const Expr& node, std::size_t i, Where where) {
    if (i == 0 && node.op == Op::intrinsic && signature_of(node.intrinsic)[0] == '@')
        return visit_target(node.operands[0], where);  // a place, not its value
    const bool may_skip = (node.op == Op::select && i > 0) ||
                          (node.op == Op::binary && i == 1 &&
                           (node.binary == BinaryOp::logical_and || node.binary == BinaryOp::logical_or));
    return visit(node.operands[i], may_skip && where == Where::before ? Where::conditional : where);
}

ExprId Sharing::visit_operands(ExprId id, Where where) {
    const Expr& node = cx.p.exprs[id];
    if (!rewrites_) {
        for (std::size_t i = 0; i < node.operands.size(); ++i) visit_operand(node, i, where);
        return id;
    }
    Operands operands;
    for (std::size_t i = 0; i < node.operands.size(); ++i) operands.push_back(visit_operand(node, i, where));
    if (operands == node.operands) return id;
    ExprId result = cx.make.again(node, std::move(operands));
    if (const Name* found = cx.names.find(id)) {
        Name name = *found;
        cx.names.emplace(result, name);
    }
    return result;
}

ExprId Sharing::visit_target(ExprId id, Where where) {
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::local) return id;
    Expr copy = node;
    copy.operands[0] = node.op == Op::load ? visit(node.operands[0], where) : visit_target(node.operands[0], where);
    if (node.op == Op::index) copy.operands[1] = visit(node.operands[1], where);
    return rewrites_ ? cx.p.exprs.add(std::move(copy)) : id;
}

/// A let that repeats an earlier value is dropped; otherwise it is the value's name from here on.
void Sharing::let_(StmtId id) {
    const Stmt& stmt = cx.p.stmts[id];
    Make::Parts parts{{}, stmt.value, {}, {}, {}};
    bool is_plain = stmt.value && !cx.p.locals[stmt.local].is_mutable && numbers_.is_pure(stmt.value);
    if (!is_plain) {
        if (stmt.value) parts.value = visit(stmt.value, Where::before);
        append(id, std::move(parts));
        return;
    }
    if (auto decided = known(stmt.value)) {
        numbers_.define(stmt.local, numbers_.of(stmt.value));
        if (rewrites_) parts.value = cx.make.truth(*decided);
        append(id, std::move(parts));
        return;
    }
    ValueNumber number = numbers_.of(stmt.value);
    const Expr& value = cx.p.exprs[stmt.value];
    bool repeats_local = value.op == Op::local && !cx.p.locals[value.local].is_mutable;
    if (repeats_local) {
        numbers_.define(stmt.local, number);
        if (rewrites_) renamed_[stmt.local] = cx.p.exprs[visit(stmt.value, Where::before)].local;
        return;
    }
    if (std::uint32_t found = available(number); found != none) {
        Record& record = records_[found];
        ++record.uses;
        if (!record.is_let && !rewrites_) record.name = cx.p.locals[stmt.local].name, record.is_let = true;
        numbers_.define(stmt.local, number);
        if (rewrites_ && record.local) {
            renamed_[stmt.local] = record.local;
            return;
        }
        if (!rewrites_) return;
    }
    if (is_leaf(stmt.value)) {
        numbers_.define(stmt.local, number);
        parts.value = visit_operands(stmt.value, Where::before);
        append(id, std::move(parts));
        return;
    }
    std::uint32_t index = new_record(number);
    if (!rewrites_) {
        records_[index].uses = 1;
        records_[index].is_let = true;
        visit_operands(stmt.value, Where::before);
    } else {
        parts.value = visit_operands(stmt.value, Where::before);
        cx.definitions[stmt.local] = parts.value;
        records_[index].local = stmt.local;
        append(id, std::move(parts));
    }
    numbers_.define(stmt.local, number);
}

void Sharing::loop_(StmtId id) {
    const Stmt& stmt = cx.p.stmts[id];
    Make::Parts parts;
    if (stmt.op == StmtOp::for_) {
        parts.value = visit(stmt.value, Where::before);
        parts.limit = visit(stmt.limit, Where::before);
        numbers_.change_all(stmt.body);
    } else {
        numbers_.change_all(stmt.body);
        parts.value = visit(stmt.value, Where::loop_condition);
    }
    parts.body = run(stmt.body);
    numbers_.change_all(stmt.body);
    append(id, std::move(parts));
}

void Sharing::statement_(StmtId id) {
    const Stmt& stmt = cx.p.stmts[id];
    span_ = stmt.span;
    switch (stmt.op) {
    case StmtOp::let: let_(id); return;
    case StmtOp::for_:
    case StmtOp::while_: loop_(id); return;
    default: break;  // expressions first, then what is inside, then what changes
    }
    Make::Parts parts{{}, {}, stmt.limit, {}, {}};
    if (stmt.value) parts.value = visit(stmt.value, Where::before);
    if (stmt.target)
        parts.target =
            stmt.op == StmtOp::assign ? visit_target(stmt.target, Where::before) : visit(stmt.target, Where::before);
    if (stmt.op == StmtOp::if_) {
        parts.body = run_knowing(stmt.body, stmt.value, true);
        parts.otherwise = run_knowing(stmt.otherwise, stmt.value, false);
    } else {
        parts.body = run(stmt.body);
        parts.otherwise = run(stmt.otherwise);
    }
    span_ = stmt.span;
    numbers_.change_all(stmt);
    append(id, std::move(parts));
}

}  // namespace

std::vector<StmtId> share(Context& cx, const std::vector<StmtId>& body, const std::vector<ExprId>& facts) {
    std::vector<Record> records;
    records.reserve(64);
    Numbers numbers(cx);
    Sharing(cx, numbers, records, facts, false).run(body);
    numbers.restart();
    return Sharing(cx, numbers, records, facts, true).run(body);
}

}  // namespace gliftc::lower
