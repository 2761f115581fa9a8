#include "lower/transform/split_structs.h"

#include "ir/walk.h"
#include "lower/analysis/leaves.h"
#include "lower/analysis/number.h"
#include "lower/build/rewrite.h"

#include <algorithm>
#include <map>

namespace gliftc::lower {

using namespace ir;

namespace {

/// Splits locals into the members of their types, not further.
class Splitting {
public:
    explicit Splitting(Context& context) : cx(context), p(context.p), numbers_(context) {}

    /// Finds the locals to split; false: there are none.
    bool find(const std::vector<StmtId>& body);
    std::vector<StmtId> run(const std::vector<StmtId>& body);
    bool has_inner() const { return has_inner_; }  ///< some of the new locals hold structs

private:
    /// A member of a split local.
    struct Member {
        bool is_assigned = false;
        LocalId local;  ///< absent: nothing uses it, or `value` has it
        ExprId value;   ///< what uses of it are replaced by
    };
    /// A local that holds a struct.
    struct Whole {
        std::vector<bool> needed;     ///< the leaves (leaves.h) whose values are used
        std::vector<bool> read;       ///< those of them that are used otherwise than by copies of the whole local
        std::vector<ExprId> given;    ///< what its `let` and assignments to all of it give it
        std::vector<LocalId> copies;  ///< the locals to which all of it is copied
        bool stays = false;
        bool is_split = false;
        std::vector<Member> members;
    };

    void learn(const Stmt& stmt);
    void learn_assignment(const Stmt& stmt);
    bool can_be_given(ExprId value);
    void keep_whole(ExprId id);
    void use(ExprId id);
    void use_leaves(Whole& whole, std::uint32_t first, std::uint32_t count);
    void use_given(const Whole& to, ExprId value);
    void use(const Stmt& stmt);
    void use_all(const std::vector<StmtId>& body);
    bool is_used_in_part(const Whole& whole) const;
    void choose();

    Whole* whole_of(LocalId local) {
        const auto found = wholes_.find(local);
        return found == wholes_.end() ? nullptr : &found->second;
    }
    Whole* split(LocalId local) {
        Whole* found = whole_of(local);
        return found != nullptr && found->is_split ? found : nullptr;
    }
    const std::vector<StructField>& fields_of(TypeId type) const { return p.structs[p.types[type].struct_].fields; }
    bool is_any(const std::vector<bool>& leaves, TypeId type, std::uint32_t slot) const;
    ExprId visit(ExprId id);
    ExprId with_address_in_local(ExprId value, std::vector<StmtId>& result);
    ExprId in_temporary(ExprId value, std::vector<StmtId>& result);
    LocalId copy_in(const std::vector<StmtId>& body, LocalId from);
    void declare(const Stmt& stmt, LocalId whole, std::uint32_t slot, ExprId value, std::vector<StmtId>& result);
    void split_let(const Stmt& stmt, const std::vector<StmtId>& body, std::vector<StmtId>& result);
    void split_assignment(const Stmt& stmt, Whole& whole, std::vector<StmtId>& result);
    void drop_assignment(const Stmt& stmt, std::vector<StmtId>& result);
    bool replace(const Stmt& stmt, const std::vector<StmtId>& body, std::vector<StmtId>& result);
    void drop_first_value(LocalId local, std::vector<StmtId>& body);

    Context& cx;
    Program& p;
    Numbers numbers_;
    std::map<LocalId, Whole> wholes_;
    std::vector<LocalId> variables_;  ///< the mutable locals that were declared in the lists around a statement
    bool grows_ = false, has_inner_ = false;
};

/// Whether members of the value can be computed one by one. `coherent` memory is loaded by the element.
bool Splitting::can_be_given(ExprId value) {
    const Expr& node = p.exprs[member_of(p, value).whole];
    if (node.op == Op::load) return !cx.pass.bindings[node.slot].coherent;
    if (node.op == Op::construct) return numbers_.is_pure(value);
    return node.op == Op::local || node.op == Op::member || node.op == Op::parameter;
}

void Splitting::learn_assignment(const Stmt& stmt) {
    ExprId below = stmt.target, target = stmt.target;
    for (; p.exprs[target].op != Op::local; target = p.exprs[target].operands[0]) below = target;
    Whole* whole = whole_of(p.exprs[target].local);
    if (whole == nullptr) return;
    if (target == stmt.target) {
        whole->given.push_back(stmt.value);
        whole->stays |= !can_be_given(stmt.value);
        for (Member& member : whole->members) member.is_assigned = true;
    } else if (p.exprs[below].op == Op::field) {
        whole->members[p.exprs[below].slot].is_assigned = true;
    } else {
        whole->stays = true;
    }
}

void Splitting::learn(const Stmt& stmt) {
    if (stmt.op == StmtOp::assign) return learn_assignment(stmt);
    if (stmt.op != StmtOp::let) return;
    const Local& local = p.locals[stmt.local];
    if (!is_struct(p, local.type) || local.storage != Storage::value) return;
    Whole& whole = wholes_[stmt.local];
    whole.stays |= !whole.members.empty() || (stmt.value && !can_be_given(stmt.value));  // not if it has two lets
    if (stmt.value) whole.given.push_back(stmt.value);
    whole.needed.resize(leaves_in(p, local.type));
    whole.read.resize(whole.needed.size());
    whole.members.resize(fields_of(local.type).size());
}

void Splitting::use_leaves(Whole& whole, std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t leaf = first; leaf < first + count; ++leaf) {
        grows_ |= !whole.needed[leaf];
        whole.needed[leaf] = true;
    }
}

/// Notes the leaves that an expression uses. A local that it uses as a whole is not split.
void Splitting::use(ExprId id) {
    const MemberOf member = member_of(p, id);
    const Expr& node = p.exprs[member.whole];
    if (node.op == Op::local) {
        Whole* whole = whole_of(node.local);
        if (whole == nullptr) return;
        const std::uint32_t count = leaves_in(p, p.exprs[id].type);
        use_leaves(*whole, member.first, count);
        std::fill_n(whole->read.begin() + member.first, count, true);
        if (member.whole == id && !whole->stays) whole->stays = grows_ = true;
        return;
    }
    for (ExprId operand : node.operands) use(operand);
}

/// Notes what is used of a value that is given to the local `to`.
void Splitting::use_given(const Whole& to, ExprId value) {
    const MemberOf member = member_of(p, value);
    const Expr& node = p.exprs[member.whole];
    if (to.stays) return use(value);
    if (node.op == Op::construct && member.whole == value) {
        std::uint32_t leaf = 0;
        for (ExprId part : node.operands) {
            const std::uint32_t count = leaves_in(p, p.exprs[part].type);
            const auto begin = to.needed.begin() + leaf;
            if (std::find(begin, begin + count, true) != begin + count) use(part);
            leaf += count;
        }
    } else if (Whole* from = node.op == Op::local ? whole_of(node.local) : nullptr) {
        for (std::uint32_t leaf = 0; leaf < to.needed.size(); ++leaf) {
            if (!to.needed[leaf]) continue;
            use_leaves(*from, member.first + leaf, 1);
            if (member.whole != value) from->read[member.first + leaf] = true;
        }
    } else {
        use(value);
    }
}

void Splitting::use(const Stmt& stmt) {
    Whole* to = nullptr;
    if (stmt.op == StmtOp::let) to = whole_of(stmt.local);
    if (stmt.op == StmtOp::assign) {
        const Expr* node = &p.exprs[stmt.target];
        if (node->op == Op::local) to = whole_of(node->local);
        for (; node->op != Op::local; node = &p.exprs[node->operands[0]])
            if (node->op == Op::index) use(node->operands[1]);
    } else if (stmt.target) {
        use(stmt.target);
    }
    if (stmt.limit) use(stmt.limit);
    for (ExprId argument : stmt.arguments) use(argument);
    if (!stmt.value) return;
    if (to == nullptr) return use(stmt.value);
    use_given(*to, stmt.value);
}

/// Whether the local is given a struct that is loaded or constructed, and of which some leaves are not used.
bool Splitting::is_used_in_part(const Whole& whole) const {
    const auto is_made = [&](ExprId value) {
        const Op op = p.exprs[member_of(p, value).whole].op;
        return op == Op::load || op == Op::construct;
    };
    return std::ranges::find(whole.needed, false) != whole.needed.end() && std::ranges::any_of(whole.given, is_made);
}

/// Chooses the locals to split. If a split local is copied, the copy is split, too.
void Splitting::choose() {
    const auto source = [&](ExprId value) {
        return p.exprs[value].op == Op::local ? whole_of(p.exprs[value].local) : nullptr;
    };
    for (auto& [local, whole] : wholes_)
        for (ExprId value : whole.given)
            if (Whole* from = source(value)) from->copies.push_back(local);
    std::vector<LocalId> chosen;
    const auto choose_one = [&](LocalId local, Whole& whole) {
        if (whole.is_split || whole.stays) return;
        whole.is_split = true;
        chosen.push_back(local);
    };
    for (auto& [local, whole] : wholes_)
        if (is_used_in_part(whole)) choose_one(local, whole);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        for (LocalId copy : whole_of(chosen[i])->copies) choose_one(copy, *whole_of(copy));
}

void Splitting::use_all(const std::vector<StmtId>& body) {
    do {
        grows_ = false;
        for_each_statement(p, body, [&](const Stmt& stmt) { use(stmt); });
    } while (grows_);
}

bool Splitting::find(const std::vector<StmtId>& body) {
    for_each_statement(p, body, [&](const Stmt& stmt) { learn(stmt); });
    if (wholes_.empty()) return false;
    use_all(body);
    choose();
    // Locals that stay whole are given all members of others, which then may have to stay whole, too.
    bool is_settled = false;
    while (!is_settled) {
        for (auto& [local, whole] : wholes_) whole.stays = !whole.is_split;
        use_all(body);
        is_settled = true;
        for (auto& [local, whole] : wholes_) {
            is_settled = is_settled && !(whole.is_split && whole.stays);
            whole.is_split = whole.is_split && !whole.stays;
        }
    }
    return std::ranges::any_of(wholes_, [](const auto& one) { return one.second.is_split; });
}

/// Whether some leaf of the field is among `leaves` of the struct.
bool Splitting::is_any(const std::vector<bool>& leaves, TypeId type, std::uint32_t slot) const {
    const auto begin = leaves.begin() + first_leaf(p, type, slot);
    const auto end = begin + leaves_in(p, fields_of(type)[slot].type);
    return std::find(begin, end, true) != end;
}

ExprId Splitting::visit(ExprId id) {
    const Expr& node = p.exprs[id];
    if (node.op == Op::field && p.exprs[node.operands[0]].op == Op::local)
        if (Whole* whole = split(p.exprs[node.operands[0]].local)) return whole->members[node.slot].value;
    return with_operands_visited(cx, id, [&](ExprId operand) { return visit(operand); });
}

ExprId Splitting::in_temporary(ExprId value, std::vector<StmtId>& result) {
    Stmt let = statement(StmtOp::let, p.exprs[value].span);
    let.local = cx.new_local("value", p.exprs[value].type, let.span);
    p.locals[let.local].is_temporary = true;
    let.value = visit(value);
    cx.definitions[let.local] = let.value;
    result.push_back(cx.add(let));
    return cx.build.local(let.local);
}

/// The value with the address of the load that it is a member of, if it is one, in a local: members that are loaded one
/// by one take the address from there.
ExprId Splitting::with_address_in_local(ExprId value, std::vector<StmtId>& result) {
    const Expr node = p.exprs[value];
    if (node.op != Op::field && node.op != Op::load) return value;
    const bool is_simple = node.op == Op::load && is_trivial(cx, node.operands[0]);
    Expr copy = node;
    if (node.op == Op::field) copy.operands[0] = with_address_in_local(node.operands[0], result);
    else if (!is_simple) copy.operands[0] = in_temporary(node.operands[0], result);
    return copy.operands[0] == node.operands[0] ? value : p.exprs.add(std::move(copy));
}

/// The split local to which the split local `from` is copied, if that is its only copy, and by a `let` in `body`.
LocalId Splitting::copy_in(const std::vector<StmtId>& body, LocalId from) {
    const std::vector<LocalId>& copies = whole_of(from)->copies;
    if (copies.size() != 1 || split(copies[0]) == nullptr) return {};
    const auto is_copy = [&](StmtId id) {
        const Stmt& stmt = p.stmts[id];
        return stmt.op == StmtOp::let && stmt.local == copies[0] && stmt.value && p.exprs[stmt.value].op == Op::local &&
               p.exprs[stmt.value].local == from;
    };
    return std::ranges::any_of(body, is_copy) ? copies[0] : LocalId{};
}

/// Declares the local of a split local's member.
void Splitting::declare(const Stmt& stmt, LocalId whole, std::uint32_t slot, ExprId value,
                        std::vector<StmtId>& result) {
    const Local of = p.locals[whole];
    const StructField field = fields_of(of.type)[slot];
    Member& member = whole_of(whole)->members[slot];
    Stmt let = stmt;
    const Name name = p.names->intern((*p.names)[of.name] + "_" + (*p.names)[field.name]);
    let.local = member.local = cx.new_local(name, field.type, of.span, member.is_assigned);
    p.locals[let.local].is_temporary = of.is_temporary;
    let.value = value;
    member.value = cx.build.local(let.local);
    has_inner_ |= is_struct(p, field.type);
    if (member.is_assigned) variables_.push_back(let.local);
    else if (value) cx.definitions[let.local] = value;
    result.push_back(cx.add(std::move(let)));
}

/// Replaces the `let` of a split local, which is in the list `body`. A member that is never assigned, of an immutable
/// local, needs no local of its own. A member that is only copied is declared as that of the copy.
void Splitting::split_let(const Stmt& stmt, const std::vector<StmtId>& body, std::vector<StmtId>& result) {
    Whole& whole = *whole_of(stmt.local);
    const TypeId type = p.locals[stmt.local].type;
    const ExprId given = stmt.value ? with_address_in_local(stmt.value, result) : stmt.value;
    const LocalId copy = copy_in(body, stmt.local);
    for (std::uint32_t slot = 0; slot < whole.members.size(); ++slot) {
        Member& member = whole.members[slot];
        if (!is_any(whole.needed, type, slot) || member.local) continue;
        const ExprId value = given ? visit(cx.build.field(given, slot)) : given;
        const bool is_renamed = !member.is_assigned && value && is_trivial(cx, value);
        if (is_renamed) member.value = value;
        else if (copy && !member.is_assigned && !is_any(whole.read, type, slot))
            declare(stmt, copy, slot, value, result);
        else declare(stmt, stmt.local, slot, value, result);
    }
}

/// Replaces an assignment to all of a split local. Where it assigns several members, all are computed before.
void Splitting::split_assignment(const Stmt& stmt, Whole& whole, std::vector<StmtId>& result) {
    const ExprId given = with_address_in_local(stmt.value, result);
    std::vector<Stmt> made;
    for (std::uint32_t slot = 0; slot < whole.members.size(); ++slot) {
        if (!whole.members[slot].local) continue;
        Stmt assign = stmt;
        assign.target = whole.members[slot].value;
        assign.value = visit(cx.build.field(given, slot));
        const Expr& value = p.exprs[assign.value];
        if (value.op != Op::local || value.local != whole.members[slot].local) made.push_back(std::move(assign));
    }
    const bool is_constructed = p.exprs[given].op == Op::construct && made.size() > 1;
    for (Stmt& assign : made)
        if (is_constructed && !cx.build.is_constant(assign.value)) assign.value = in_temporary(assign.value, result);
    for (Stmt& assign : made) result.push_back(cx.add(std::move(assign)));
}

/// Replaces an assignment to a member of a split local that nothing uses: only effects of its value are left.
void Splitting::drop_assignment(const Stmt& stmt, std::vector<StmtId>& result) {
    if (numbers_.is_pure(stmt.value)) return;
    Stmt alone = statement(StmtOp::evaluate, stmt.span);
    alone.value = visit(stmt.value);
    result.push_back(cx.add(std::move(alone)));
}

/// Replaces a `let` of a split local, or an assignment to one; false: the statement is something else.
bool Splitting::replace(const Stmt& stmt, const std::vector<StmtId>& body, std::vector<StmtId>& result) {
    if (stmt.op == StmtOp::let) {
        const bool is_split = split(stmt.local) != nullptr;
        if (is_split) split_let(stmt, body, result);
        return is_split;
    }
    if (stmt.op != StmtOp::assign) return false;
    Whole* whole = split(place_of(p, stmt.target).local);
    if (whole == nullptr) return false;
    ExprId member = stmt.target;
    while (p.exprs[member].op != Op::local && p.exprs[p.exprs[member].operands[0]].op != Op::local)
        member = p.exprs[member].operands[0];
    if (p.exprs[member].op == Op::local) split_assignment(stmt, *whole, result);
    else if (!whole->members[p.exprs[member].slot].local) drop_assignment(stmt, result);
    else return false;
    return true;
}

/// If the first statement that mentions the variable after its `let` in `body` gives it another value, that statement
/// declares it.
void Splitting::drop_first_value(LocalId local, std::vector<StmtId>& body) {
    const auto let = std::ranges::find_if(
        body, [&](StmtId id) { return p.stmts[id].op == StmtOp::let && p.stmts[id].local == local; });
    if (let == body.end()) return;
    const auto next = std::find_if(let + 1, body.end(), [&](StmtId id) { return mentions(p, {id}, local); });
    if (next == body.end()) return;
    Stmt declares = p.stmts[*next];
    const bool is_given = declares.op == StmtOp::assign && p.exprs[declares.target].op == Op::local &&
                          p.exprs[declares.target].local == local && !mentions(p, declares.value, local);
    if (!is_given) return;
    const Stmt before = p.stmts[*let];
    if (before.value && !numbers_.is_pure(before.value)) return;
    declares.op = StmtOp::let;
    declares.local = local;
    declares.target = {};
    *next = cx.add(std::move(declares));
    bool is_assigned = false;
    for_each_statement(p, {next + 1, body.end()}, [&](const Stmt& stmt) {
        is_assigned = is_assigned || (stmt.op == StmtOp::assign && place_of(p, stmt.target).local == local);
    });
    p.locals[local].is_mutable = is_assigned;
    if (!is_assigned) cx.definitions[local] = p.stmts[*next].value;
    body.erase(let);
}

std::vector<StmtId> Splitting::run(const std::vector<StmtId>& body) {
    const std::size_t outer = variables_.size();
    std::vector<StmtId> result;
    result.reserve(body.size());
    for (StmtId id : body) {
        const Stmt stmt = p.stmts[id];
        if (replace(stmt, body, result)) continue;
        Builder::Parts parts = visited_parts(stmt, [&](ExprId part) { return visit(part); });
        parts.body = run(stmt.body);
        parts.otherwise = run(stmt.otherwise);
        result.push_back(cx.build.again(id, std::move(parts)));
    }
    for (; variables_.size() > outer; variables_.pop_back()) drop_first_value(variables_.back(), result);
    return result;
}

/// Notes the new values of locals. What was known to be uniform, or not to be, may have changed with them.
void define_again(Context& cx, const std::vector<StmtId>& body) {
    for_each_statement(cx.p, body, [&](const Stmt& stmt) {
        if (stmt.op == StmtOp::let && stmt.value && cx.definitions.find(stmt.local) != nullptr)
            cx.definitions[stmt.local] = stmt.value;
    });
    cx.uniform_sizes.clear();
}

}  // namespace

std::vector<StmtId> split_structs(Context& cx, const std::vector<StmtId>& body) {
    std::vector<StmtId> result = body;
    for (bool again = true; again;) {
        Splitting splitting(cx);
        if (!splitting.find(result)) break;
        result = splitting.run(result);
        again = splitting.has_inner();
        define_again(cx, result);
    }
    return result;
}

}  // namespace gliftc::lower
