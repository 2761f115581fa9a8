#include "lower/transform/compact.h"

#include <vector>

namespace gliftc::lower {

using namespace ir;

namespace {

/// Moves the nodes of one arena that were made after the mark: keep() marks those that stay, close_gaps() moves them,
/// renumber() replaces their old ids by the new ones.
template <class T> class Moves {
public:
    Moves(Arena<T>& arena, std::uint32_t first) : arena_(arena), first_(first), to_(arena.size() - first, gone) {}

    /// Marks a node as kept. True if it was made after the mark and not kept before: its operands are still to visit.
    bool keep(Id<T> id) {
        if (!id || id.index < first_ || to_[id.index - first_] != gone) return false;
        to_[id.index - first_] = stays;
        return true;
    }
    /// Moves the kept nodes together.
    void close_gaps() {
        std::uint32_t next = first_;
        for (std::uint32_t i = 0; i < to_.size(); ++i) {
            if (to_[i] == gone) continue;
            if (next != first_ + i) arena_[{next}] = std::move(arena_[{first_ + i}]);
            to_[i] = next++;
        }
        arena_.truncate(next);
    }
    void renumber(Id<T>& id) const {
        if (id && id.index >= first_) id.index = to_[id.index - first_];
    }

private:
    static constexpr std::uint32_t gone = 0xffffffffu, stays = 0;

    Arena<T>& arena_;
    std::uint32_t first_;
    std::vector<std::uint32_t> to_;
};

class Compaction {
public:
    Compaction(Program& program, const Mark& mark)
        : p(program), mark_(mark), exprs_(program.exprs, mark.exprs), stmts_(program.stmts, mark.stmts) {}

    void run(std::span<Pass* const> passes) {
        for_each_root(
            passes, [&](ExprId& id) { keep(id); }, [&](std::vector<StmtId>& body) { keep(body); });
        exprs_.close_gaps();
        stmts_.close_gaps();
        for (std::uint32_t i = mark_.exprs; i < p.exprs.size(); ++i)
            for (ExprId& operand : p.exprs[{i}].operands) exprs_.renumber(operand);
        for (std::uint32_t i = mark_.stmts; i < p.stmts.size(); ++i) renumber(p.stmts[{i}]);
        for_each_root(
            passes, [&](ExprId& id) { exprs_.renumber(id); }, [&](std::vector<StmtId>& body) { renumber_all(body); });
    }

private:
    template <class VisitExpr, class VisitBody>
    void for_each_root(std::span<Pass* const> passes, VisitExpr&& expr, VisitBody&& body) {
        for (Pass* pass : passes) {
            for (PassParameter& parameter : pass->parameters) expr(parameter.value);
            for (auto* each : bodies_of(*pass)) body(*each);
            for (Variant& variant : pass->variants)
                for (Bounds& bounds : variant.assumes.bounds)
                    for (ExprId* part : {&bounds.value, &bounds.low, &bounds.high}) expr(*part);
        }
        for (std::uint32_t i = mark_.functions; i < p.functions.size(); ++i) body(p.functions[{i}].body);
    }

    void keep(ExprId id) {
        if (!exprs_.keep(id)) return;
        for (ExprId operand : p.exprs[id].operands) keep(operand);
    }
    void keep(const std::vector<StmtId>& body) {
        for (StmtId id : body) {
            if (!stmts_.keep(id)) continue;
            const Stmt& stmt = p.stmts[id];
            for (ExprId root : {stmt.target, stmt.value, stmt.limit}) keep(root);
            for (ExprId argument : stmt.arguments) keep(argument);
            keep(stmt.body);
            keep(stmt.otherwise);
        }
    }

    template <class Body> void renumber_all(Body& body) {
        for (StmtId& id : body) stmts_.renumber(id);
    }
    void renumber(Stmt& stmt) {
        for (ExprId* root : {&stmt.target, &stmt.value, &stmt.limit}) exprs_.renumber(*root);
        for (ExprId& argument : stmt.arguments) exprs_.renumber(argument);
        renumber_all(stmt.body);
        renumber_all(stmt.otherwise);
    }

    Program& p;
    const Mark& mark_;
    Moves<Expr> exprs_;
    Moves<Stmt> stmts_;
};

}  // namespace

void compact(Program& program, const Mark& mark, std::span<Pass* const> passes) {
    Compaction(program, mark).run(passes);
}

}  // namespace gliftc::lower
