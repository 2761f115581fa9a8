#include "lower/host/split_at_barriers.h"

#include "ir/walk.h"
#include "lower/transform/dead.h"

#include <map>
#include <set>

namespace gliftc::lower {

using namespace ir;

namespace {

bool has_barrier(const Program& program, StmtId id) {
    bool found = false;
    for_each_statement(program, {id}, [&](const Stmt& stmt) { found = found || stmt.op == StmtOp::barrier; });
    return found;
}

/// Whether the statement contains a break or continue of a loop around it.
bool escapes(const Program& program, StmtId id) {
    const Stmt& stmt = program.stmts[id];
    if (stmt.op == StmtOp::break_ || stmt.op == StmtOp::continue_) return true;
    if (stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_) return false;
    for (const auto* list : {&stmt.body, &stmt.otherwise})
        for (StmtId inner : *list)
            if (escapes(program, inner)) return true;
    return false;
}

class Splitting {
public:
    explicit Splitting(Context& context) : cx(context) {}

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> split = regions(body, false), result;
        for (const auto& [local, used_in] : uses_) {
            if (used_in.size() < 2 || uniform_.contains(local)) continue;
            if (cx.p.locals[local].storage == Storage::shared) continue;
            Stmt keep = statement(StmtOp::keep, {});
            keep.local = local;
            result.push_back(cx.add(std::move(keep)));
        }
        result.insert(result.end(), split.begin(), split.end());
        return result;
    }

private:
    std::vector<StmtId> regions(const std::vector<StmtId>& body, bool in_loop) {
        std::vector<StmtId> result, pending;
        for (StmtId id : body) {
            if (!has_barrier(cx.p, id) && !(in_loop && escapes(cx.p, id))) {
                pending.push_back(id);
                continue;
            }
            add_region(pending, result);
            result.push_back(uniform(id, in_loop));
        }
        add_region(pending, result);
        return result;
    }

    void add_region(std::vector<StmtId>& pending, std::vector<StmtId>& to) {
        if (pending.empty()) return;
        ++region_;
        note(pending);
        Stmt stmt = statement(StmtOp::invocations, {});
        stmt.body = std::exchange(pending, {});
        to.push_back(cx.add(std::move(stmt)));
    }

    StmtId uniform(StmtId id, bool in_loop) {
        ++region_;
        const Stmt& stmt = cx.p.stmts[id];
        const bool is_loop = stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_;
        for (ExprId expr : {stmt.value, stmt.limit}) note(expr);
        if (stmt.op == StmtOp::for_) uniform_.insert(stmt.local);
        Builder::Parts parts{stmt.target, stmt.value, stmt.limit, {}, {}};
        parts.body = regions(stmt.body, in_loop || is_loop);
        parts.otherwise = regions(stmt.otherwise, in_loop);
        return cx.build.again(id, std::move(parts));
    }

    void note(ExprId id) {
        for_each_node(cx.p, id, [&](ExprId node) {
            const Expr& expr = cx.p.exprs[node];
            if (expr.op == Op::local) uses_[expr.local].insert(region_);
        });
    }

    void note(const std::vector<StmtId>& statements) {
        for_each_statement(cx.p, statements, [&](const Stmt& stmt) {
            if (stmt.op == StmtOp::let || stmt.op == StmtOp::for_) uses_[stmt.local].insert(region_);
            for (ExprId expr : {stmt.target, stmt.value, stmt.limit}) note(expr);
        });
    }

    Context& cx;
    /// The number of the current region: an `invocations` statement, or a single statement outside of them.
    std::uint32_t region_ = 0;
    std::map<LocalId, std::set<std::uint32_t>> uses_;  ///< the regions that use each local
    std::set<LocalId> uniform_;                        ///< variables of loops that all invocations execute together
};

}  // namespace

std::vector<StmtId> regions_between_barriers(Context& cx, const std::vector<StmtId>& body) {
    return Splitting(cx).run(body);
}

std::vector<StmtId> split_at_barriers(Context& cx, const std::vector<StmtId>& body) {
    std::vector<StmtId> whole = cx.pass.prologue;
    whole.insert(whole.end(), body.begin(), body.end());
    // drop_dead leaves out the statements of the prologue that declare `address` and `in_range`, where nothing uses
    // them.
    return regions_between_barriers(cx, drop_dead(cx, whole));
}

}  // namespace gliftc::lower
