#include "ir/walk.h"
#include "lower/share.h"

#include <algorithm>
#include <functional>

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

/// The statement's value as an `evaluate`: it has an effect, but the local that it would be assigned to is dead.
StmtId effect_alone(Context& cx, const Stmt& stmt, Live& live) {
    Stmt alone = statement(StmtOp::evaluate, stmt.span);
    alone.value = stmt.value;
    use(cx.p, alone.value, live.used);
    return cx.add(std::move(alone));
}

/// The statements that stay. Walks backwards, so that what only dropped statements used is dropped, too.
std::vector<StmtId> kept(Context& cx, const std::vector<StmtId>& body, Live& live) {
    std::vector<StmtId> result;
    result.reserve(body.size());
    for (std::size_t i = body.size(); i-- > 0;) {
        const Stmt& stmt = cx.p.stmts[body[i]];
        if (stmt.op == StmtOp::if_ && stmt.otherwise.empty() && cx.make.is_false(stmt.value)) continue;
        if (stmt.op == StmtOp::if_ && cx.make.is_true(stmt.value)) {
            const std::vector<StmtId> always = kept(cx, stmt.body, live);
            result.insert(result.end(), always.rbegin(), always.rend());
            continue;
        }
        const bool is_dead_let = stmt.op == StmtOp::let && !live.used.contains(stmt.local);
        if (is_dead_let || is_dead_assignment(cx.p, stmt, live)) {
            if (stmt.value && has_effect(cx.p, stmt.value)) result.push_back(effect_alone(cx, stmt, live));
            continue;
        }
        Make::Parts parts{stmt.target, stmt.value, stmt.limit, {}, {}};
        parts.body = kept(cx, stmt.body, live);
        parts.otherwise = kept(cx, stmt.otherwise, live);
        bool is_empty = parts.body.empty() && parts.otherwise.empty();
        if (is_empty && does_nothing_empty(cx.p, stmt)) continue;
        for_each_root(stmt, [&](ExprId root) { use(cx.p, root, live.used); });
        result.push_back(cx.make.again(body[i], std::move(parts)));
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

/// Finds the locals whose values are needed: some statement uses them other than to set a local that is not needed.
void note_read(const Program& p, const std::vector<StmtId>& body, const IdSet<Local>& declared, IdSet<Local>& read) {
    bool grows = true;
    const std::function<void(ExprId)> note = [&](ExprId id) {
        const Expr& node = p.exprs[id];
        if (node.op == Op::local) grows |= read.insert(node.local);
        for (ExprId operand : node.operands) note(operand);
    };
    while (grows) {
        grows = false;
        for_each_statement(p, body, [&](const Stmt& stmt) {
            const LocalId to = given(p, stmt, declared);
            if (to && !read.contains(to)) return;
            const bool is_whole = stmt.op == StmtOp::assign && p.exprs[stmt.target].op == Op::local;
            for_each_root(stmt, [&](ExprId root) {
                if (!is_whole || root != stmt.target) note(root);
            });
        });
    }
}

/// Marks as used the needed locals that loops assign: a later iteration may read what an earlier one assigned, which a
/// backward walk over the body does not see.
void use_in_loops(const Program& p, const std::vector<StmtId>& body, const IdSet<Local>& declared, IdSet<Local>& used) {
    IdSet<Local> read;
    note_read(p, body, declared, read);
    for_each_statement(p, body, [&](const Stmt& stmt) {
        if (stmt.op != StmtOp::for_ && stmt.op != StmtOp::while_) return;
        for_each_statement(p, stmt.body, [&](const Stmt& inner) {
            if (inner.op != StmtOp::assign) return;
            const LocalId local = assigned(p, inner);
            if (!local || read.contains(local)) use(p, inner.target, used);
        });
    });
}

}  // namespace

std::vector<StmtId> drop_dead(Context& cx, const std::vector<StmtId>& body) {
    Live live;
    for_each_statement(cx.p, body, [&](const Stmt& stmt) {
        if (stmt.op == StmtOp::let) live.declared.insert(stmt.local);
    });
    use_in_loops(cx.p, body, live.declared, live.used);
    return kept(cx, body, live);
}

}  // namespace gliftc::lower
