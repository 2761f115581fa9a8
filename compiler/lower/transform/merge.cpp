#include "ir/walk.h"
#include "lower/analysis/number.h"
#include "lower/build/rewrite.h"
#include "lower/transform/share.h"

namespace gliftc::lower {

using namespace ir;

namespace {

class Merging {
public:
    explicit Merging(Context& context) : cx(context), numbers_(context) {}

    void count(const std::vector<StmtId>& body, unsigned loops);
    std::vector<StmtId> run(const std::vector<StmtId>& body);

private:
    struct Use {
        unsigned count = 0;
        unsigned loops = 0;     ///< number of loops around the use
        unsigned declared = 0;  ///< number of loops around the let
    };

    void count(ExprId id, unsigned loops);
    bool is_merged(const Stmt& stmt, ExprId value);
    ExprId visit(ExprId id);

    Context& cx;
    Numbers numbers_;
    NodeMap<LocalId, Use> uses_{cx.first_local};
    NodeMap<LocalId, ExprId> values_{cx.first_local};
};

void Merging::count(ExprId id, unsigned loops) {
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::local) {
        Use& use = uses_[node.local];
        ++use.count;
        use.loops = loops;
    }
    for (ExprId operand : node.operands) count(operand, loops);
}

void Merging::count(const std::vector<StmtId>& body, unsigned loops) {
    for (StmtId id : body) {
        const Stmt& stmt = cx.p.stmts[id];
        bool is_loop = stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_;
        if (stmt.op == StmtOp::let) uses_[stmt.local].declared = loops;
        for_each_root(stmt, [&](ExprId root) { count(root, stmt.op == StmtOp::while_ ? loops + 1 : loops); });
        count(stmt.body, loops + is_loop);
        count(stmt.otherwise, loops);
    }
}

/// Whether the `let` is dropped and its value moved to its only use.
bool Merging::is_merged(const Stmt& stmt, ExprId value) {
    if (stmt.op != StmtOp::let || !value || !cx.p.locals[stmt.local].is_temporary) return false;
    const Use& use = uses_[stmt.local];
    return use.count == 1 && use.loops == use.declared && numbers_.is_fixed(value);
}

ExprId Merging::visit(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::local) {
        const ExprId* found = values_.find(node.local);
        return found == nullptr ? id : *found;
    }
    return with_operands_visited(cx, id, [&](ExprId operand) { return visit(operand); });
}

std::vector<StmtId> Merging::run(const std::vector<StmtId>& body) {
    const auto visited = [&](ExprId part) { return visit(part); };
    const auto take = [&](const Stmt& stmt, ExprId value, std::vector<StmtId>&) {
        if (!is_merged(stmt, value)) return false;
        values_[stmt.local] = value;
        return true;
    };
    return rebuilt(cx, body, visited, take);
}

}  // namespace

std::vector<StmtId> merge_single_uses(Context& cx, const std::vector<StmtId>& body) {
    Merging merging(cx);
    merging.count(body, 0);
    return merging.run(body);
}

}  // namespace gliftc::lower
