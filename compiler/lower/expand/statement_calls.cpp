// Expander: calls that are expanded as statements of the caller, not as expressions. These are calls of functions with
// a group, whose barriers and workgroup memory are the kernel's, and of functions that write structures or access them
// coherently (Function::effects), which must be executed exactly once, where the call is.
#include "lower/analysis/unroll.h"
#include "lower/expand/expand.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

/// Whether the function returns only by its last statement, if at all.
bool returns_at_end(const Program& p, const Function& function) {
    if (function.body.empty()) return true;
    const std::vector<StmtId> before(function.body.begin(), function.body.end() - 1);
    return !returns(p, before) && (p.stmts[function.body.back()].op == StmtOp::return_ || !returns(p, function.body));
}

/// Whether every path through the statements ends in a return, as far as the last statement shows; false if an earlier
/// one always returns and the last one does not.
bool always_leaves(const Program& p, const std::vector<StmtId>& body) {
    if (body.empty()) return false;
    const Stmt& last = p.stmts[body.back()];
    if (last.op == StmtOp::return_) return true;
    if (last.op == StmtOp::block) return always_leaves(p, last.body);
    return last.op == StmtOp::if_ && always_leaves(p, last.body) && always_leaves(p, last.otherwise);
}

std::vector<StmtId> joined(const std::vector<StmtId>& first, const std::vector<StmtId>& rest) {
    std::vector<StmtId> all(first);
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
}

}  // namespace

Pair Expander::expand_as_statements(const Expr& node) {
    const Function function = p.functions[node.function];
    Frame frame;
    for (const Place& place : node.places) frame.places.push_back(resolved(place));
    frame.prefix = frame_->prefix;
    frame.result = function.result;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const std::string name = prefixed((*p.names)[p.locals[function.params[i]].name]);
        Pair argument = expand(node.operands[i]);
        argument.value = named(name, argument.value);
        if (argument.has) argument.has = named(name + "_found", argument.has);
        frame.locals[function.params[i]] = argument;
    }
    for (LocalId shared : function.shared)
        if (std::ranges::find(cx.pass.shared, shared) == cx.pass.shared.end()) cx.pass.shared.push_back(shared);
    const std::string name = prefixed((*p.names)[function.name]);
    return inside(std::move(frame), [&]() -> Pair {
        if (!returns_at_end(p, function)) return leave_early(function, name);
        for (StmtId id : function.body) {
            const Stmt& stmt = p.stmts[id];
            if (stmt.op != StmtOp::return_) {
                expand_statement(id);
                continue;
            }
            Pair result = stmt.value ? expand(stmt.value) : Pair{};
            if (result.value) result.value = named(name, result.value);
            if (result.has) result.has = named(name + "_found", result.has);
            return result;
        }
        return {};
    });
}

/// Expands a function that returns before its end (see Leaving).
Pair Expander::leave_early(const Function& function, const std::string& name) {
    Leaving leaving;
    const bool is_optional = p.types.kind(function.result) == TypeKind::optional;
    const TypeId type = is_optional ? p.types[function.result].element : function.result;
    const bool has_value = type != p.types.void_ && !is_empty(p, type);
    if (has_value) leaving.value = variable(name, type, build.zero(type));
    if (is_optional) leaving.has = variable(name + "_found", p.types.bool_, build.truth(false));
    if (asks_whether_left(function.body, false))
        leaving.left = variable(name + "_left", p.types.bool_, build.truth(false));
    frame_->leaving = &leaving;
    expand_body(function.body);
    frame_->leaving = nullptr;
    Pair result;
    if (has_value) result.value = build.local(leaving.value);
    else if (type != p.types.void_) result.value = build.zero(type);
    if (is_optional) result.has = build.local(leaving.has);
    return result;
}

/// Whether a variable is needed that says whether a return was executed (Leaving::left): for statements that follow a
/// return and cannot be moved into the other side of an `if`, and to leave a loop around the loop that has the return.
bool Expander::asks_whether_left(const std::vector<StmtId>& body, bool is_in_loop) const {
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Stmt& stmt = p.stmts[body[i]];
        if (!returns(p, {body[i]})) continue;
        const bool has_rest = i + 1 < body.size();
        switch (stmt.op) {
        case StmtOp::return_: return false;
        case StmtOp::for_:
        case StmtOp::while_:
            if (has_rest || is_in_loop || asks_whether_left(stmt.body, true)) return true;
            break;
        default: {
            const bool one_leaves = always_leaves(p, stmt.body) != always_leaves(p, stmt.otherwise);
            const bool other_stays = !returns(p, stmt.body) || !returns(p, stmt.otherwise);
            if (has_rest && !is_in_loop && !(stmt.op == StmtOp::if_ && one_leaves && other_stays)) return true;
            if (asks_whether_left(stmt.body, is_in_loop) || asks_whether_left(stmt.otherwise, is_in_loop)) return true;
        }
        }
    }
    return false;
}

void Expander::expand_leaving(const std::vector<StmtId>& body) {
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Stmt& stmt = p.stmts[body[i]];
        const std::vector<StmtId> rest(body.begin() + static_cast<std::ptrdiff_t>(i) + 1, body.end());
        if (returns(p, {body[i]}) && expand_past(stmt, rest)) return;
        if (stmt.op == StmtOp::return_ || !returns(p, {body[i]})) expand_statement(body[i]);
        if (stmt.op == StmtOp::return_) return;
    }
}

/// Expands a statement that may return, such that the statements after it (`rest`) are skipped if it does. True if this
/// has expanded `rest`, too. Does nothing for a `return` itself, which the caller expands.
bool Expander::expand_past(const Stmt& stmt, const std::vector<StmtId>& rest) {
    if (stmt.op == StmtOp::return_) return false;
    const bool is_in_loop = frame_->leaving->loops != 0;
    if (stmt.op == StmtOp::block) {
        expand_leaving(joined(stmt.body, rest));
        return true;
    }
    if (stmt.op == StmtOp::if_) {
        const ExprId condition = value_of(stmt.value);
        if (build.is_true(condition) || build.is_false(condition)) {
            expand_leaving(joined(build.is_true(condition) ? stmt.body : stmt.otherwise, rest));
            return true;
        }
        const bool yes_leaves = !is_in_loop && always_leaves(p, stmt.body) && !returns(p, stmt.otherwise);
        const bool no_leaves = !is_in_loop && always_leaves(p, stmt.otherwise) && !returns(p, stmt.body);
        Block yes = nested(joined(stmt.body, no_leaves ? rest : std::vector<StmtId>{}));
        Block no = nested(joined(stmt.otherwise, yes_leaves ? rest : std::vector<StmtId>{}));
        append_if(condition, std::move(yes), std::move(no));
        if (yes_leaves || no_leaves) return true;
        if (is_in_loop) return false;  // a return breaks out of the loop, so that `rest` is skipped in any case
    } else {
        if (stmt.op == StmtOp::for_) expand_for(stmt);
        else expand_while(stmt);
        if (is_in_loop) {
            Block leave = collect([&] { append(statement(StmtOp::break_, stmt.span)); });
            append_if(build.local(frame_->leaving->left), std::move(leave), {});
            return false;
        }
    }
    if (rest.empty()) return true;
    Block last = collect([&] { expand_leaving(rest); });
    append_if(build.negate(build.local(frame_->leaving->left)), std::move(last), {});
    return true;
}

void Expander::expand_leave(const Stmt& stmt) {
    const Leaving& leaving = *frame_->leaving;
    if (stmt.value) {
        const Pair result = expand(stmt.value);
        if (leaving.value) assign(leaving.value, result.value);
        if (leaving.has) assign(leaving.has, result.has);
    }
    if (leaving.left) assign(leaving.left, build.truth(true));
    if (leaving.loops != 0) append(statement(StmtOp::break_, stmt.span));
}

}  // namespace gliftc::lower
