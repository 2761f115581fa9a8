#include "lower/transform/narrow_stores.h"

#include "ir/walk.h"
#include "lower/analysis/leaves.h"
#include "lower/analysis/number.h"
#include "lower/build/node_map.h"

#include <algorithm>
#include <map>
#include <utility>

namespace gliftc::lower {

using namespace ir;

namespace {

/// A set of leaves (leaves.h) of one type.
using Leaves = std::vector<bool>;

/// The load that a leaf's value comes from.
struct Origin {
    LocalId holder;  ///< the local whose `let` has the load; none: it is in the expression itself
    ExprId load;
    ExprId guard;            ///< if not absent, the value comes from the load only where this condition holds
    std::uint32_t leaf = 0;  ///< index among the leaves of the loaded element
    bool operator==(const Origin&) const = default;
};

class Narrowing {
public:
    explicit Narrowing(Context& context) : cx(context), p(context.p), numbers_(context) {}

    /// Whether some store is of a struct, to memory that the body also loads from.
    bool is_needed(const std::vector<StmtId>& body) const;
    void learn(const std::vector<StmtId>& body);
    std::vector<StmtId> run(const std::vector<StmtId>& body);

private:
    /// A local that holds a struct.
    struct Holder {
        ExprId initial;  ///< its value where `guard` holds, from its `let` on or from the `if` behind the `let` on
        ExprId guard;    ///< absent: its `let` gives it the value
        std::vector<ExprId> assigned;  ///< the values of other assignments to all of it
        Leaves kept;                   ///< the leaves that have their initial value throughout
        std::uint64_t time = 0;        ///< when it was declared
    };
    /// The memory of bindings that may alias each other.
    struct Memory {
        Leaves constant;                   ///< the leaves that no store of the body changes
        std::vector<std::uint64_t> times;  ///< when each leaf may have changed last
    };

    /// The leaves of an element that a store writes.
    struct Stored {
        std::uint32_t first = 0, count = 0;
    };

    Stored stored_by(const Stmt& store) const;
    bool takes_part(const PassBinding& binding) const;
    Memory* memory_of(const Stmt& store);
    void learn_values(const std::vector<StmtId>& body);
    bool learn_let(const Stmt& let, const Stmt* next);
    void learn_assignment(const Stmt& stmt);
    void learn_stores(const std::vector<StmtId>& body);
    void learn_store(const Stmt& stmt);
    bool holds(ExprId condition);
    bool keeps_less(LocalId local, Holder& holder) const;
    std::optional<Origin> origin(ExprId id, std::uint32_t leaf) const;
    std::optional<Origin> origin(LocalId local, std::uint32_t leaf) const;
    bool is_own(const Stmt& store, const std::optional<Origin>& origin, std::uint32_t leaf);
    Leaves changed_by(const Stmt& store, Memory& memory);
    void note_changes(const std::vector<StmtId>& loop);
    void run_inner(const Stmt& stmt, Builder::Parts& parts);
    void store(StmtId id, std::vector<StmtId>& result);
    void store_members(Stmt made, const Leaves& changed, std::uint32_t first, std::vector<StmtId>& result);
    ExprId in_temporary(ExprId value, std::string_view name, std::vector<StmtId>& result);

    Context& cx;
    Program& p;
    Numbers numbers_;                 ///< is told of no changes, and asked for values that do not change
    std::vector<ExprId> conditions_;  ///< of the `if`s around the current statement
    std::uint64_t time_ = 0;
    std::map<LocalId, Holder> holders_;
    std::map<std::uint32_t, Memory> memories_;  ///< by PassBinding::one_place
};

Narrowing::Stored Narrowing::stored_by(const Stmt& store) const {
    Stored stored;
    TypeId type = cx.pass.bindings[store.slot].element;
    for (std::uint32_t slot : store.path) {
        stored.first += first_leaf(p, type, slot);
        type = p.structs[p.types[type].struct_].fields[slot].type;
    }
    stored.count = leaves_in(p, type);
    return stored;
}

bool Narrowing::takes_part(const PassBinding& binding) const {
    return binding.shape == MemoryShape::buffer && is_struct(p, binding.element) && !binding.coherent &&
           !binding.atomic && binding.access == Access::read_write;
}

bool Narrowing::is_needed(const std::vector<StmtId>& body) const {
    if (std::ranges::none_of(cx.pass.bindings, [&](const PassBinding& binding) { return takes_part(binding); }))
        return false;
    bool found = false;
    for_each_statement(p, body, [&](const Stmt& stmt) {
        found = found || (stmt.op == StmtOp::store && takes_part(cx.pass.bindings[stmt.slot]));
    });
    return found;
}

Narrowing::Memory* Narrowing::memory_of(const Stmt& store) {
    const auto found = memories_.find(cx.pass.bindings[store.slot].one_place);
    return found == memories_.end() ? nullptr : &found->second;
}

/// Where the value of one leaf comes from; none if that is not a load, or not known.
std::optional<Origin> Narrowing::origin(ExprId id, std::uint32_t leaf) const {
    const MemberOf member = member_of(p, id);
    const Expr& node = p.exprs[member.whole];
    leaf += member.first;
    if (node.op == Op::load) return Origin{{}, member.whole, {}, leaf};
    if (node.op == Op::construct && is_struct(p, node.type)) {
        for (ExprId part : node.operands) {
            const std::uint32_t count = leaves_in(p, p.exprs[part].type);
            if (leaf < count) return origin(part, leaf);
            leaf -= count;
        }
        return std::nullopt;
    }
    return node.op == Op::local ? origin(node.local, leaf) : std::nullopt;
}

std::optional<Origin> Narrowing::origin(LocalId local, std::uint32_t leaf) const {
    const auto found = holders_.find(local);
    if (found == holders_.end() || !found->second.kept[leaf]) return std::nullopt;
    std::optional<Origin> result = origin(found->second.initial, leaf);
    if (result && !result->holder) result->holder = local;
    if (result && found->second.guard) result->guard = found->second.guard;
    return result;
}

void Narrowing::learn_assignment(const Stmt& stmt) {
    const MemberOf whole = member_of(p, stmt.target);
    if (p.exprs[whole.whole].op == Op::local) {
        const auto found = holders_.find(p.exprs[whole.whole].local);
        if (found == holders_.end()) return;
        if (whole.whole == stmt.target) return found->second.assigned.push_back(stmt.value);
        const auto first = found->second.kept.begin() + whole.first;
        return std::fill(first, first + leaves_in(p, p.exprs[stmt.target].type), false), void();
    }
    // A part of a leaf: the field that has it is the outermost one below the indices and components.
    ExprId leaf = stmt.target;
    while (leaf && p.exprs[leaf].op != Op::field && p.exprs[leaf].op != Op::local) leaf = p.exprs[leaf].operands[0];
    const MemberOf member = member_of(p, leaf);
    const auto found = holders_.find(place_of(p, leaf).local);
    if (found == holders_.end()) return;
    if (p.exprs[member.whole].op == Op::local) found->second.kept[member.first] = false;
    else found->second.kept.assign(found->second.kept.size(), false);
}

/// Learns the `let` of a struct. Returns whether `next`, the statement behind it, is a part of it: `if guard { local =
/// load; }`, as accesses under a condition are expanded.
bool Narrowing::learn_let(const Stmt& let, const Stmt* next) {
    Holder holder{let.value, {}, {}, Leaves(leaves_in(p, p.locals[let.local].type), !holders_.contains(let.local))};
    bool is_guarded = false;
    if (next != nullptr && next->op == StmtOp::if_ && next->body.size() == 1 && next->otherwise.empty()) {
        const Stmt& inner = p.stmts[next->body[0]];
        is_guarded = inner.op == StmtOp::assign && p.exprs[inner.target].op == Op::local &&
                     p.exprs[inner.target].local == let.local && p.exprs[inner.value].op == Op::load &&
                     numbers_.is_fixed(next->value);
        if (is_guarded) holder.initial = inner.value, holder.guard = next->value;
    }
    if (holder.initial) holders_.insert_or_assign(let.local, std::move(holder));
    return is_guarded;
}

void Narrowing::learn_values(const std::vector<StmtId>& body) {
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Stmt& stmt = p.stmts[body[i]];
        if (stmt.op == StmtOp::assign) learn_assignment(stmt);
        learn_values(stmt.body);
        learn_values(stmt.otherwise);
        if (stmt.op != StmtOp::let || !is_struct(p, p.locals[stmt.local].type)) continue;
        if (learn_let(stmt, i + 1 < body.size() ? &p.stmts[body[i + 1]] : nullptr)) ++i;
    }
}

/// Takes from the leaves that the local keeps those to which it is assigned another value than its initial one.
bool Narrowing::keeps_less(LocalId local, Holder& holder) const {
    bool any = false;
    for (ExprId value : holder.assigned) {
        for (std::uint32_t leaf = 0; leaf < holder.kept.size(); ++leaf) {
            if (!holder.kept[leaf]) continue;
            const std::optional<Origin> now = origin(value, leaf);
            if (now && now->holder && now == origin(local, leaf)) continue;
            holder.kept[leaf] = false;
            any = true;
        }
    }
    return any;
}

void Narrowing::learn_store(const Stmt& stmt) {
    const PassBinding& binding = cx.pass.bindings[stmt.slot];
    if (!is_struct(p, binding.element)) return;
    const std::uint32_t count = leaves_in(p, binding.element);
    Memory& memory = memories_.try_emplace(binding.one_place, Memory{Leaves(count, true), {}}).first->second;
    memory.times.resize(count);
    const Stored stored = stored_by(stmt);
    for (std::uint32_t leaf = 0; leaf < stored.count; ++leaf)
        if (!is_own(stmt, origin(stmt.value, leaf), stored.first + leaf)) memory.constant[stored.first + leaf] = false;
}

void Narrowing::learn_stores(const std::vector<StmtId>& body) {
    for (StmtId id : body) {
        const Stmt& stmt = p.stmts[id];
        if (stmt.op == StmtOp::store) learn_store(stmt);
        if (stmt.op == StmtOp::if_) conditions_.push_back(stmt.value);
        learn_stores(stmt.body);
        if (stmt.op == StmtOp::if_) conditions_.pop_back();
        learn_stores(stmt.otherwise);
    }
}

void Narrowing::learn(const std::vector<StmtId>& body) {
    learn_values(body);
    bool any = true;
    while (any) {
        any = false;
        for (auto& [local, holder] : holders_) any |= keeps_less(local, holder);
    }
    learn_stores(body);
}

/// Whether an `if` around the statement asks for the condition, whose value does not change.
bool Narrowing::holds(ExprId condition) {
    return std::ranges::any_of(conditions_, [&](ExprId known) {
        return numbers_.is_fixed(known) && numbers_.of(known) == numbers_.of(condition);
    });
}

/// Whether the origin is a load of this leaf from the binding and address of the store. The address does not change
/// between the two, nor does the guard: is_fixed() leaves the locals that they use no values but one for each iteration
/// of the loop around their `let`s, and these lets are around the holder's, too.
bool Narrowing::is_own(const Stmt& store, const std::optional<Origin>& origin, std::uint32_t leaf) {
    if (!origin || origin->leaf != leaf) return false;
    if (origin->guard && !holds(origin->guard)) return false;
    const Expr& load = p.exprs[origin->load];
    if (load.slot != store.slot || !takes_part(cx.pass.bindings[store.slot])) return false;
    const ExprId from = load.operands[0];
    return numbers_.is_fixed(from) && numbers_.is_fixed(store.target) && numbers_.of(from) == numbers_.of(store.target);
}

/// The leaves that the store may change. Notes when they changed.
Leaves Narrowing::changed_by(const Stmt& store, Memory& memory) {
    Leaves changed(memory.constant.size());
    const Stored stored = stored_by(store);
    for (std::uint32_t leaf = stored.first; leaf < stored.first + stored.count; ++leaf) {
        const std::optional<Origin> from = origin(store.value, leaf - stored.first);
        const auto is_current = [&] {
            return !from->holder || memory.constant[leaf] || memory.times[leaf] < holders_.at(from->holder).time;
        };
        changed[leaf] = !is_own(store, from, leaf) || !is_current();
        if (changed[leaf]) memory.times[leaf] = ++time_;
    }
    return changed;
}

/// Notes that what a loop stores may change before each iteration.
void Narrowing::note_changes(const std::vector<StmtId>& loop) {
    for_each_statement(p, loop, [&](const Stmt& stmt) {
        if (stmt.op != StmtOp::store) return;
        Memory* memory = memory_of(stmt);
        if (memory != nullptr) memory->times.assign(memory->times.size(), ++time_);
    });
}

ExprId Narrowing::in_temporary(ExprId value, std::string_view name, std::vector<StmtId>& result) {
    Stmt let = statement(StmtOp::let, p.exprs[value].span);
    let.local = cx.new_local(name, p.exprs[value].type, let.span);
    p.locals[let.local].is_temporary = true;
    let.value = value;
    cx.definitions[let.local] = value;
    result.push_back(cx.add(let));
    return cx.build.local(let.local);
}

/// Adds a store for each member with leaves that change, as few as possible. `made` is a store to the member whose
/// first leaf is `first`.
void Narrowing::store_members(Stmt made, const Leaves& changed, std::uint32_t first, std::vector<StmtId>& result) {
    const TypeId type = p.exprs[made.value].type;
    const auto begin = changed.begin() + first, end = begin + leaves_in(p, type);
    if (std::find(begin, end, true) == end) return;
    if (std::find(begin, end, false) == end) return result.push_back(cx.add(std::move(made)));
    const std::size_t fields = p.structs[p.types[type].struct_].fields.size();
    for (std::uint32_t slot = 0; slot < fields; ++slot) {
        Stmt member = made;
        std::vector<std::uint32_t> path = made.path;
        path.push_back(slot);
        member.path = std::move(path);
        member.value = cx.build.field(made.value, slot);
        store_members(std::move(member), changed, first + first_leaf(p, type, slot), result);
    }
}

void Narrowing::store(StmtId id, std::vector<StmtId>& result) {
    const Stmt stmt = p.stmts[id];
    Memory* memory = memory_of(stmt);
    if (memory == nullptr) return result.push_back(id);
    const Leaves changed = changed_by(stmt, *memory);
    const Stored stored = stored_by(stmt);
    if (std::ranges::count(changed, true) == stored.count) return result.push_back(id);
    const std::size_t before = result.size();
    store_members(stmt, changed, stored.first, result);
    if (result.size() - before < 2) return;
    // The members are computed before the first of them is stored, and the address is computed once.
    std::vector<StmtId> stores(result.begin() + static_cast<std::ptrdiff_t>(before), result.end());
    result.resize(before);
    const ExprId address = is_trivial(cx, stmt.target) ? stmt.target : in_temporary(stmt.target, "at", result);
    for (StmtId& member : stores) {
        Stmt made = p.stmts[member];
        made.target = address;
        if (numbers_.has_load(made.value)) made.value = in_temporary(made.value, "value", result);
        member = cx.add(std::move(made));
    }
    result.insert(result.end(), stores.begin(), stores.end());
}

/// The statement's inner statements. What one branch of an `if` stores is not stored before the other one.
void Narrowing::run_inner(const Stmt& stmt, Builder::Parts& parts) {
    if (stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_) note_changes(stmt.body);
    const std::map<std::uint32_t, Memory> before = memories_;
    if (stmt.op == StmtOp::if_) conditions_.push_back(stmt.value);
    parts.body = run(stmt.body);
    if (stmt.op == StmtOp::if_) conditions_.pop_back();
    if (stmt.otherwise.empty()) return;
    const std::map<std::uint32_t, Memory> first = std::exchange(memories_, before);
    parts.otherwise = run(stmt.otherwise);
    for (auto& [place, memory] : memories_)
        for (std::size_t leaf = 0; leaf < memory.times.size(); ++leaf)
            memory.times[leaf] = std::max(memory.times[leaf], first.at(place).times[leaf]);
}

std::vector<StmtId> Narrowing::run(const std::vector<StmtId>& body) {
    std::vector<StmtId> result;
    result.reserve(body.size());
    for (StmtId id : body) {
        const Stmt stmt = p.stmts[id];
        if (stmt.op == StmtOp::store) {
            store(id, result);
            continue;
        }
        if (stmt.op == StmtOp::let)
            if (const auto holder = holders_.find(stmt.local); holder != holders_.end()) holder->second.time = ++time_;
        Builder::Parts parts{stmt.target, stmt.value, stmt.limit, {}, {}};
        run_inner(stmt, parts);
        result.push_back(cx.build.again(id, std::move(parts)));
    }
    return result;
}

}  // namespace

std::vector<StmtId> narrow_stores(Context& cx, const std::vector<StmtId>& body) {
    Narrowing narrowing(cx);
    if (!narrowing.is_needed(body)) return body;
    narrowing.learn(body);
    return narrowing.run(body);
}

}  // namespace gliftc::lower
