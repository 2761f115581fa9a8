#include "ir/walk.h"
#include "lower/number.h"
#include "lower/share.h"

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
        unsigned loops = 0;     ///< around the use
        unsigned declared = 0;  ///< loops around the let
    };

    void count(ExprId id, unsigned loops);
    bool is_merged(const Stmt& stmt);
    ExprId visit(ExprId id);

    Context& cx;
    Numbers numbers_;
    std::unordered_map<LocalId, Use> uses_;
    std::unordered_map<LocalId, ExprId> values_;
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

bool Merging::is_merged(const Stmt& stmt) {
    if (stmt.op != StmtOp::let || !stmt.value || !cx.made.contains(stmt.local)) return false;
    const Use& use = uses_[stmt.local];
    return use.count == 1 && use.loops == use.declared && numbers_.is_fixed(stmt.value);
}

ExprId Merging::visit(ExprId id) {
    const Expr node = cx.p.exprs[id];
    if (node.op == Op::local) {
        auto found = values_.find(node.local);
        return found == values_.end() ? id : found->second;
    }
    Operands operands;
    for (ExprId operand : node.operands) operands.push_back(visit(operand));
    if (operands == node.operands) return id;
    Expr copy = node;
    copy.operands = std::move(operands);
    return cx.p.exprs.add(std::move(copy));
}

std::vector<StmtId> Merging::run(const std::vector<StmtId>& body) {
    std::vector<StmtId> result;
    for (StmtId id : body) {
        Stmt copy = cx.p.stmts[id];
        if (copy.value) copy.value = visit(copy.value);
        if (copy.target) copy.target = visit(copy.target);
        if (copy.limit) copy.limit = visit(copy.limit);
        if (is_merged(copy)) {
            values_[copy.local] = copy.value;
            continue;
        }
        copy.body = run(copy.body);
        copy.otherwise = run(copy.otherwise);
        result.push_back(cx.add(std::move(copy)));
    }
    return result;
}

}  // namespace

std::vector<StmtId> merge_single_uses(Context& cx, const std::vector<StmtId>& body) {
    Merging merging(cx);
    merging.count(body, 0);
    return merging.run(body);
}

}  // namespace gliftc::lower
