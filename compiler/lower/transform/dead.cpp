#include "lower/transform/dead.h"

#include "ir/walk.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

bool has_effect(const Program& p, ExprId id) {
    bool effect = false;
    for_each_node(p, id, [&](ExprId part) {
        const Expr& node = p.exprs[part];
        if (node.op != Op::intrinsic) return;
        std::string_view signature = signature_of(node.intrinsic);
        effect = effect || signature[0] == '@' || signature.back() == '*';
    });
    return effect;
}

void use(const Program& p, ExprId id, IdSet<Local>& used) {
    const Expr& node = p.exprs[id];
    if (node.op == Op::local) used.insert(node.local);
    for (ExprId operand : node.operands) use(p, operand, used);
}

/// What is known at a statement during the walk from the end of the body to its beginning.
struct Live {
    IdSet<Local> used;      ///< locals that later statements use
    IdSet<Local> declared;  ///< locals that the body declares: nothing outside of it reads them
};

/// The local that an assignment changes, wholly or in part; none if the statement is anything else or its target has
/// effects.
LocalId assigned(const Program& p, const Stmt& stmt) {
    if (stmt.op != StmtOp::assign || has_effect(p, stmt.target)) return {};
    const Expr& root = place_of(p, stmt.target);
    return root.op == Op::local ? root.local : LocalId{};
}

/// Whether the statement assigns to a local of the body that no later statement uses.
bool is_dead_assignment(const Program& p, const Stmt& stmt, const Live& live) {
    const LocalId local = assigned(p, stmt);
    return local && live.declared.contains(local) && !live.used.contains(local);
}

/// Whether a statement with bodies can be dropped once these are empty. Not a while loop, which might not end.
bool does_nothing_empty(const Program& p, const Stmt& stmt) {
    const bool ends = stmt.op == StmtOp::if_ || stmt.op == StmtOp::block || stmt.op == StmtOp::for_;
    return ends && !(stmt.value && has_effect(p, stmt.value)) && !(stmt.limit && has_effect(p, stmt.limit));
}

/// The statement's value as an `evaluate`: the value has an effect, but the local that it would be assigned to is dead.
StmtId effect_alone(Program& p, const Stmt& stmt, Live& live) {
    Stmt alone = statement(StmtOp::evaluate, stmt.span);
    alone.value = stmt.value;
    use(p, alone.value, live.used);
    return p.stmts.add(std::move(alone));
}

/// Whether the statement is a return, break or continue: no statement that follows it in its list is reached.
bool leaves(const Stmt& stmt) {
    return stmt.op == StmtOp::return_ || stmt.op == StmtOp::break_ || stmt.op == StmtOp::continue_;
}

/// The statements that stay. Walks backwards: after a statement has been dropped, statements before it that only set
/// locals for it are dropped, too.
std::vector<StmtId> kept(Builder& build, const std::vector<StmtId>& body, Live& live) {
    std::vector<StmtId> result;
    result.reserve(body.size());
    for (std::size_t i = body.size(); i-- > 0;) {
        const Stmt& stmt = build.p.stmts[body[i]];
        if (leaves(stmt)) result.clear();
        if (stmt.op == StmtOp::if_ && stmt.otherwise.empty() && build.is_false(stmt.value)) continue;
        if (stmt.op == StmtOp::if_ && build.is_true(stmt.value)) {
            const std::vector<StmtId> always = kept(build, stmt.body, live);
            if (!always.empty() && leaves(build.p.stmts[always.back()])) result.clear();
            result.insert(result.end(), always.rbegin(), always.rend());
            continue;
        }
        const bool is_dead_let = stmt.op == StmtOp::let && !live.used.contains(stmt.local);
        if (is_dead_let || is_dead_assignment(build.p, stmt, live)) {
            if (stmt.value && has_effect(build.p, stmt.value)) result.push_back(effect_alone(build.p, stmt, live));
            continue;
        }
        Builder::Parts parts{stmt.target, stmt.value, stmt.limit, {}, {}};
        parts.body = kept(build, stmt.body, live);
        parts.otherwise = kept(build, stmt.otherwise, live);
        bool is_empty = parts.body.empty() && parts.otherwise.empty();
        if (is_empty && does_nothing_empty(build.p, stmt)) continue;
        for_each_root(stmt, [&](ExprId root) { use(build.p, root, live.used); });
        result.push_back(build.again(body[i], std::move(parts)));
    }
    std::reverse(result.begin(), result.end());
    return result;
}

/// The local of the body that a statement sets, if that is all it does; else none.
LocalId given(const Program& p, const Stmt& stmt, const IdSet<Local>& declared) {
    if (stmt.value && has_effect(p, stmt.value)) return {};
    if (stmt.op == StmtOp::let) return stmt.local;
    const LocalId local = assigned(p, stmt);
    return local && declared.contains(local) ? local : LocalId{};
}

/// Finds the locals whose values are needed: a needed statement uses them. Not needed are statements that only set a
/// local whose value is not needed, and ifs, blocks and for loops that contain nothing else.
class Needed {
public:
    Needed(const Program& program, const std::vector<StmtId>& body, const IdSet<Local>& declared)
        : p(program), declared_(declared) {
        do {
            grows_ = false;
            note(body);
        } while (grows_);
    }

    bool contains(LocalId local) const { return locals_.contains(local); }

private:
    /// Notes the locals that needed statements use. Returns whether a statement of the body is needed, as far as is
    /// known yet.
    template <class Statements> bool note(const Statements& body) {
        bool any = false;
        for (StmtId id : body) any |= note(p.stmts[id]);
        return any;
    }

    bool note(const Stmt& stmt) {
        const bool has_needed = bool(note(stmt.body) | note(stmt.otherwise));
        if (!has_needed && does_nothing_empty(p, stmt)) return false;
        const LocalId to = given(p, stmt, declared_);
        if (to && !locals_.contains(to)) return false;
        const bool is_whole = stmt.op == StmtOp::assign && p.exprs[stmt.target].op == Op::local;
        for_each_root(stmt, [&](ExprId root) {
            if (!is_whole || root != stmt.target) use_of(root);
        });
        return true;
    }

    void use_of(ExprId id) {
        const Expr& node = p.exprs[id];
        if (node.op == Op::local) grows_ |= locals_.insert(node.local);
        for (ExprId operand : node.operands) use_of(operand);
    }

    const Program& p;
    const IdSet<Local>& declared_;
    IdSet<Local> locals_;
    bool grows_ = false;
};

/// Marks as used the needed locals that loops assign: a later iteration may read what an earlier one assigned, which a
/// backward walk over the body does not see.
void use_in_loops(const Program& p, const std::vector<StmtId>& body, const IdSet<Local>& declared, IdSet<Local>& used) {
    const Needed needed(p, body, declared);
    for_each_statement(p, body, [&](const Stmt& stmt) {
        if (stmt.op != StmtOp::for_ && stmt.op != StmtOp::while_) return;
        for_each_statement(p, stmt.body, [&](const Stmt& inner) {
            if (inner.op != StmtOp::assign) return;
            const LocalId local = assigned(p, inner);
            if (!local || needed.contains(local)) use(p, inner.target, used);
        });
    });
}

std::vector<StmtId> without_dead(Builder& build, const std::vector<StmtId>& body) {
    Live live;
    for_each_statement(build.p, body, [&](const Stmt& stmt) {
        if (stmt.op == StmtOp::let) live.declared.insert(stmt.local);
    });
    use_in_loops(build.p, body, live.declared, live.used);
    return kept(build, body, live);
}

}  // namespace

std::vector<StmtId> drop_dead(Context& cx, const std::vector<StmtId>& body) { return without_dead(cx.build, body); }

std::vector<FunctionId> drop_dead(Program& program) {
    Builder build(program);
    std::vector<FunctionId> changed;
    for (std::uint32_t i = 0; i < program.functions.size(); ++i) {
        const FunctionId id{i};
        if (!program.functions[id].structures.empty()) continue;  // passes call lowered instances of it (instances.cpp)
        std::vector<StmtId> body = without_dead(build, program.functions[id].body);
        if (body == program.functions[id].body) continue;
        program.functions[id].body = std::move(body);
        changed.push_back(id);
    }
    return changed;
}

}  // namespace gliftc::lower
