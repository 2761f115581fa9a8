#include "lower/predicate.h"

#include "ir/walk.h"
#include "lower/number.h"
#include "lower/rewrite.h"

namespace gliftc::lower {

using namespace ir;

namespace {

/// `let value = memory[condition ? at : other]`, of which every use is `condition ? value : otherwise`.
struct Guarded {
    ExprId condition, at;
    ExprId otherwise;  ///< of the first use
    LocalId variable;  ///< once it is made
};

class Predicating {
public:
    explicit Predicating(Context& context) : cx(context), numbers_(context) {}

    void find(const std::vector<StmtId>& body);
    bool found() const { return any_; }
    std::vector<StmtId> run(const std::vector<StmtId>& body);

private:
    ExprId defined(ExprId id);
    void find_load(const Stmt& stmt);
    void check_uses(ExprId id);
    Guarded* chosen(const Expr& node);
    bool is_same(ExprId a, ExprId b);
    void load(StmtId id, const Guarded& guarded, std::vector<StmtId>& result);
    ExprId visit(ExprId id);

    Context& cx;
    Numbers numbers_;
    NodeMap<LocalId, ExprId> values_{cx.first_local};  ///< of the lets of the body
    NodeMap<LocalId, Guarded> guarded_{cx.first_local};
    bool any_ = false;
};

bool Predicating::is_same(ExprId a, ExprId b) {
    return numbers_.is_fixed(a) && numbers_.is_fixed(b) && numbers_.of(a) == numbers_.of(b);
}

/// What a local stands for: an address that is used twice has a name.
ExprId Predicating::defined(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    const ExprId* value = node.op == Op::local ? values_.find(node.local) : nullptr;
    return value == nullptr ? id : *value;
}

void Predicating::find_load(const Stmt& stmt) {
    if (stmt.op != StmtOp::let || !stmt.value || cx.p.locals[stmt.local].is_mutable) return;
    values_[stmt.local] = stmt.value;
    const Expr& value = cx.p.exprs[stmt.value];
    if (value.op != Op::load && value.op != Op::image_load) return;
    const Expr& address = cx.p.exprs[defined(value.operands[0])];
    if (address.op != Op::select || !numbers_.is_fixed(address.operands[1])) return;
    guarded_[stmt.local] = {address.operands[0], address.operands[1], {}, {}};
    any_ = true;
}

/// The load of which `node` is the choice, if it is one.
Guarded* Predicating::chosen(const Expr& node) {
    if (node.op != Op::select || cx.p.exprs[node.operands[1]].op != Op::local) return nullptr;
    Guarded* found = guarded_.find(cx.p.exprs[node.operands[1]].local);
    if (found == nullptr || !found->condition || !is_same(node.operands[0], found->condition)) return nullptr;
    const bool is_first = !found->otherwise;
    if (is_first ? !cx.make.is_constant(node.operands[2]) : !is_same(node.operands[2], found->otherwise))
        return nullptr;
    return found;
}

/// What is used in another way is no longer one of them.
void Predicating::check_uses(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (Guarded* guarded = chosen(node)) {
        guarded->otherwise = node.operands[2];
        return check_uses(node.operands[0]);
    }
    if (node.op == Op::local) {
        if (Guarded* found = guarded_.find(node.local)) found->condition = {};
    }
    for (ExprId operand : node.operands) check_uses(operand);
}

void Predicating::find(const std::vector<StmtId>& body) {
    for (StmtId id : body) {
        const Stmt& stmt = cx.p.stmts[id];
        for_each_root(stmt, [&](ExprId root) { check_uses(root); });
        find_load(stmt);
        find(stmt.body);
        find(stmt.otherwise);
    }
}

void Predicating::load(StmtId id, const Guarded& guarded, std::vector<StmtId>& result) {
    const Stmt stmt = cx.p.stmts[id];
    Stmt first = stmt;
    first.local = guarded.variable;
    first.value = guarded.otherwise;
    result.push_back(cx.add(std::move(first)));
    Stmt inside = statement(StmtOp::assign, stmt.span);
    inside.target = cx.make.local(guarded.variable);
    Expr loaded = cx.p.exprs[stmt.value];
    loaded.operands[0] = visit(guarded.at);
    inside.value = cx.p.exprs.add(std::move(loaded));
    Stmt branch = statement(StmtOp::if_, stmt.span);
    branch.value = visit(guarded.condition);
    branch.body = {cx.add(std::move(inside))};
    result.push_back(cx.add(std::move(branch)));
}

ExprId Predicating::visit(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::select && cx.p.exprs[node.operands[1]].op == Op::local) {
        const Guarded* found = guarded_.find(cx.p.exprs[node.operands[1]].local);
        if (found != nullptr && found->variable) return cx.make.local(found->variable);
    }
    return with_operands_visited(cx, id, [&](ExprId operand) { return visit(operand); });
}

std::vector<StmtId> Predicating::run(const std::vector<StmtId>& body) {
    std::vector<StmtId> result;
    result.reserve(body.size());
    for (StmtId id : body) {
        const Stmt& stmt = cx.p.stmts[id];
        Guarded* guarded = stmt.op == StmtOp::let ? guarded_.find(stmt.local) : nullptr;
        if (guarded != nullptr && guarded->condition && guarded->otherwise) {
            const Local& local = cx.p.locals[stmt.local];
            guarded->variable = cx.new_local(local.name, local.type, local.span, true);
            load(id, *guarded, result);
            continue;
        }
        Make::Parts parts = visited_parts(stmt, [&](ExprId part) { return visit(part); });
        parts.body = run(stmt.body);
        parts.otherwise = run(stmt.otherwise);
        result.push_back(cx.make.again(id, std::move(parts)));
    }
    return result;
}

}  // namespace

std::vector<StmtId> predicate_loads(Context& cx, const std::vector<StmtId>& body) {
    Predicating predicating(cx);
    predicating.find(body);
    return predicating.found() ? predicating.run(body) : body;
}

}  // namespace gliftc::lower
