#include "lower/transform/temporaries.h"

#include "ir/chain.h"
#include "ir/walk.h"

#include <algorithm>
#include <map>

namespace gliftc::lower {

using namespace ir;

namespace {

bool uses(const Program& p, StmtId id, LocalId local) {
    const Stmt& stmt = p.stmts[id];
    if (stmt.local == local) return true;
    bool found = false;
    for_each_root(stmt, [&](ExprId root) { found = found || mentions(p, root, local); });
    auto inner = [&](StmtId nested) { found = found || uses(p, nested, local); };
    std::for_each(stmt.body.begin(), stmt.body.end(), inner);
    std::for_each(stmt.otherwise.begin(), stmt.otherwise.end(), inner);
    return found;
}

bool is_returned(const Program& p, const std::vector<StmtId>& body, LocalId local) {
    bool found = false;
    for_each_statement(p, body, [&](const Stmt& stmt) {
        if (stmt.op != StmtOp::return_ || !stmt.value) return;
        found = found || mentions(p, stmt.value, local);
    });
    return found;
}

/// Whether the expression is a value that a pass computes into memory of its own, so that it keeps no operand alive.
bool is_computed(const Program& p, ExprId id) {
    const Expr& expr = p.exprs[id];
    return expr.op == Op::pipeline_call && p.pipelines[expr.pipeline()].is_value;
}

/// The temporary and all locals that may refer to its memory: slices, structures and device values made from it, and
/// temporaries whose constructors were given it. Using one is using the temporary.
std::vector<LocalId> aliases(const Program& p, const std::vector<StmtId>& body, LocalId temporary) {
    std::vector<LocalId> result{temporary};
    for (std::size_t i = 0; i < result.size(); ++i) {
        for_each_statement(p, body, [&](const Stmt& stmt) {
            const auto add = [&] {
                if (std::find(result.begin(), result.end(), stmt.local) == result.end()) result.push_back(stmt.local);
            };
            if (stmt.op == StmtOp::temp) {
                bool is_given = false;
                for_each_root(stmt, [&](ExprId root) {
                    is_given = is_given || (p.types.kind(p.exprs[root].type) == TypeKind::structure &&
                                            mentions(p, root, result[i]));
                });
                if (is_given) add();
                return;
            }
            if (stmt.op != StmtOp::let || !stmt.value) return;
            TypeKind kind = p.types.kind(p.locals[stmt.local].type);
            if (kind != TypeKind::slice && kind != TypeKind::structure && kind != TypeKind::device) return;
            if (is_computed(p, stmt.value)) return;
            if (mentions(p, stmt.value, result[i])) add();
        });
    }
    return result;
}

/// The device_read of an element of the temporary, if that is the value of the `let` or `return`; else null.
Expr* read_of(Program& p, const Stmt& stmt, LocalId temporary) {
    if ((stmt.op != StmtOp::let && stmt.op != StmtOp::return_) || !stmt.value) return nullptr;
    Expr& read = p.exprs[stmt.value];
    const bool is_its = read.op == Op::device_read && read.local == temporary && read.place.members.empty();
    return is_its ? &read : nullptr;
}

/// Marks reads of a temporary's elements that need no copy, since no later statement uses the temporary: returns, and
/// `let`s in the list of statements in which it is declared (a loop makes the temporary anew in each iteration).
void mark_last_reads(Program& p, const std::vector<StmtId>& body, std::size_t at) {
    const LocalId temporary = p.stmts[body[at]].local;
    for_each_statement(p, body, [&](const Stmt& stmt) {
        if (stmt.op != StmtOp::return_) return;
        if (Expr* read = read_of(p, stmt, temporary)) read->slot = 1;
    });
    std::vector<LocalId> names{temporary};
    for (LocalId alias : aliases(p, body, temporary)) {
        if (p.types.kind(p.locals[alias].type) != TypeKind::device) names.push_back(alias);
    }
    for (std::size_t k = body.size(); k-- > at + 1;) {
        if (Expr* read = read_of(p, p.stmts[body[k]], temporary)) read->slot = 1;
        if (std::ranges::any_of(names, [&](LocalId name) { return uses(p, body[k], name); })) return;
    }
}

/// Whether the structure stores its elements in memory that it makes. The elements that are accessed through a view or
/// a container, or through a structure whose memory is another one that it was given, lie in other structures.
bool has_own_memory(const Program& p, LocalId local) {
    const Structure* structure = &p.structures[p.types[p.locals[local].type].structure];
    if (structure->kind != StructureKind::stored) return false;
    for (; !structure->base.empty(); structure = &structure_at(p, *structure, structure->base))
        if (structure->members[structure->base[0]].by_reference) return false;
    return structure->kind == StructureKind::stored;
}

/// Whether the statement may write the memory that a device_read without a copy refers to. A dispatch may if it writes
/// through a local that is not itself one of `temporaries`. It also may if the memory is a temporary's (`is_temporary`)
/// and it writes through one of `names`, the locals that refer to that memory. Calls of pipelines that are not values
/// (Pipeline::is_value) may, and so may all statements other than dispatch, `let`, `temp` and `assign`.
bool may_write(const Program& p, const Stmt& stmt, const std::vector<LocalId>& names, bool is_temporary,
               const std::vector<LocalId>& temporaries) {
    const auto is_among = [](const std::vector<LocalId>& list, LocalId local) {
        return std::ranges::find(list, local) != list.end();
    };
    if (stmt.op == StmtOp::dispatch) {
        const Kernel& kernel = p.kernels[stmt.kernel()];
        for (std::size_t i = 0; i < kernel.params.size(); ++i) {
            if (kernel.params[i].direction == Direction::in) continue;
            const LocalId written = p.exprs[stmt.arguments[i]].local;
            if (is_temporary ? is_among(names, written) || !is_among(temporaries, written)
                             : !is_among(temporaries, written))
                return true;
        }
        return false;
    }
    if (stmt.op != StmtOp::let && stmt.op != StmtOp::temp && stmt.op != StmtOp::assign) return true;
    bool calls = false;
    for_each_root(stmt, [&](ExprId root) {
        for_each_node(p, root, [&](ExprId node) {
            const Expr& expr = p.exprs[node];
            calls = calls || (expr.op == Op::pipeline_call && !p.pipelines[expr.pipeline()].is_value);
        });
    });
    return calls;
}

/// Marks reads that need no copy. The read is the value of an immutable local, which the pipeline does not return; no
/// statement of `body` after it, up to and including the last one that uses the value, may write the element; and no
/// assignment uses the value.
void mark_reads(Program& p, const std::vector<StmtId>& body, const std::vector<StmtId>& pipeline) {
    std::vector<LocalId> temporaries;
    for_each_statement(p, pipeline, [&](const Stmt& stmt) {
        if (stmt.op == StmtOp::temp && has_own_memory(p, stmt.local)) temporaries.push_back(stmt.local);
    });
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Stmt& stmt = p.stmts[body[i]];
        if (stmt.op != StmtOp::let || !stmt.value || p.locals[stmt.local].is_mutable) continue;
        Expr& read = p.exprs[stmt.value];
        if (read.op != Op::device_read || is_returned(p, pipeline, stmt.local)) continue;
        const bool is_temporary = std::ranges::find(temporaries, read.local) != temporaries.end();
        std::vector<LocalId> names;
        if (is_temporary) names = aliases(p, pipeline, read.local);
        const std::vector<LocalId> values = aliases(p, pipeline, stmt.local);
        bool is_written = false, is_late = false;
        for (std::size_t k = i + 1; k < body.size(); ++k) {
            const Stmt& later = p.stmts[body[k]];
            const bool is_used = std::ranges::any_of(values, [&](LocalId value) { return uses(p, body[k], value); });
            is_written = is_written || may_write(p, later, names, is_temporary, temporaries);
            is_late = is_late || (is_used && (is_written || later.op == StmtOp::assign));
        }
        if (!is_late) read.slot = 1;
    }
}

/// Those of the aliases that a `let` declares after the temporary in the same list of statements. They are released
/// together with it (aliases that are temporaries are released on their own). Since a release changes them, they are
/// made mutable here.
std::vector<LocalId> declared_beside(Program& p, const std::vector<StmtId>& body, std::size_t at,
                                     const std::vector<LocalId>& aliases) {
    std::vector<LocalId> result;
    for (std::size_t k = at + 1; k < body.size(); ++k) {
        const Stmt& stmt = p.stmts[body[k]];
        if (stmt.op != StmtOp::let || std::ranges::find(aliases, stmt.local) == aliases.end()) continue;
        p.locals[stmt.local].is_mutable = true;
        result.push_back(stmt.local);
    }
    return result;
}

std::vector<StmtId> released(Program& p, const std::vector<StmtId>& body, const std::vector<StmtId>& pipeline) {
    mark_reads(p, body, pipeline);
    std::map<std::size_t, std::vector<LocalId>> deaths;
    const auto dies = [&](std::size_t at, LocalId local) {
        std::vector<LocalId>& dead = deaths[at];
        if (std::ranges::find(dead, local) == dead.end()) dead.push_back(local);
    };
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Stmt& stmt = p.stmts[body[i]];
        if (stmt.op != StmtOp::temp) continue;
        std::size_t last = i;
        bool leaves = false;
        const std::vector<LocalId> names = aliases(p, pipeline, stmt.local);
        for (LocalId alias : names) {
            leaves = leaves || is_returned(p, pipeline, alias);
            for (std::size_t k = i; k < body.size(); ++k)
                if (uses(p, body[k], alias)) last = std::max(last, k);
        }
        if (!leaves) {
            dies(last, stmt.local);
            for (LocalId alias : declared_beside(p, body, i, names)) dies(last, alias);
        }
        mark_last_reads(p, body, i);
    }
    std::vector<StmtId> result;
    for (std::size_t i = 0; i < body.size(); ++i) {
        Stmt& stmt = p.stmts[body[i]];
        if (!stmt.body.empty()) stmt.body = released(p, stmt.body, pipeline);
        if (!stmt.otherwise.empty()) stmt.otherwise = released(p, stmt.otherwise, pipeline);
        result.push_back(body[i]);
        auto found = deaths.find(i);
        if (found == deaths.end()) continue;
        Stmt release;
        release.op = StmtOp::release;
        release.span = p.stmts[body[i]].span;
        release.locals = found->second;
        result.push_back(p.stmts.add(std::move(release)));
    }
    return result;
}

}  // namespace

void release_temporaries(Program& program) {
    for (Pipeline& pipeline : program.pipelines) {
        std::vector<StmtId> body = released(program, pipeline.body, pipeline.body);
        pipeline.body = std::move(body);
    }
}

}  // namespace gliftc::lower
