#include "lower/transform/narrow_loads.h"

#include "ir/walk.h"
#include "lower/build/node_map.h"
#include "lower/build/rewrite.h"

namespace gliftc::lower {

using namespace ir;

namespace {

class Narrowing {
public:
    explicit Narrowing(Context& context) : cx(context) {}

    void count(const std::vector<StmtId>& body);
    std::vector<StmtId> run(const std::vector<StmtId>& body);

private:
    /// What is read of a local.
    struct Use {
        bool is_read = false, is_whole = false;  ///< `is_whole`: also if it is assigned to, or two components are read
        std::uint8_t lane = 0;                   ///< the only component that is read, unless `is_whole`
        LocalId component;                       ///< in a narrowed `let`: the local that holds the component instead
    };

    void count(ExprId id);
    void count_component(Use& use, std::uint8_t lane);
    bool is_narrowed(const Stmt& stmt);
    ExprId visit(ExprId id);
    StmtId narrowed(const Stmt& stmt, ExprId value);

    Context& cx;
    NodeMap<LocalId, Use> uses_{cx.first_local};
};

/// Whether the node is one component of a local.
bool is_component(const Program& p, const Expr& node) {
    return node.op == Op::swizzle && !p.types.is_vector(node.type) && p.exprs[node.operands[0]].op == Op::local;
}

/// Whether the value is a loaded element, or a field of one.
bool is_loaded(const Program& p, ExprId id) {
    const Expr& node = p.exprs[id];
    return node.op == Op::load || (node.op == Op::field && is_loaded(p, node.operands[0]));
}

void Narrowing::count_component(Use& use, std::uint8_t lane) {
    use.is_whole |= use.is_read && use.lane != lane;
    use.is_read = true;
    use.lane = lane;
}

void Narrowing::count(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (is_component(cx.p, node)) return count_component(uses_[cx.p.exprs[node.operands[0]].local], node.lanes[0]);
    if (node.op == Op::local) uses_[node.local].is_whole = true;
    for (ExprId operand : node.operands) count(operand);
}

void Narrowing::count(const std::vector<StmtId>& body) {
    for_each_statement(cx.p, body, [&](const Stmt& stmt) {
        for_each_root(stmt, [&](ExprId root) { count(root); });
        if (!stmt.target) return;
        const Expr& place = place_of(cx.p, stmt.target);
        if (place.op == Op::local) uses_[place.local].is_whole = true;
    });
}

bool Narrowing::is_narrowed(const Stmt& stmt) {
    if (stmt.op != StmtOp::let || !stmt.value || !is_loaded(cx.p, stmt.value)) return false;
    if (!cx.p.types.is_vector(cx.p.locals[stmt.local].type)) return false;
    const Use& use = uses_[stmt.local];
    return use.is_read && !use.is_whole;
}

ExprId Narrowing::visit(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    if (is_component(cx.p, node)) {
        const LocalId component = uses_[cx.p.exprs[node.operands[0]].local].component;
        return component ? cx.build.local(component) : id;
    }
    return with_operands_visited(cx, id, [&](ExprId operand) { return visit(operand); });
}

StmtId Narrowing::narrowed(const Stmt& stmt, ExprId value) {
    Use& use = uses_[stmt.local];
    const Local whole = cx.p.locals[stmt.local];
    Stmt let = stmt;
    let.local = use.component = cx.new_local(whole.name, cx.p.types.scalar_of(whole.type), whole.span);
    let.value = cx.build.component(value, use.lane);
    cx.p.locals[let.local].is_temporary = whole.is_temporary;
    return cx.add(std::move(let));
}

std::vector<StmtId> Narrowing::run(const std::vector<StmtId>& body) {
    const auto visited = [&](ExprId part) { return visit(part); };
    const auto take = [&](const Stmt& stmt, ExprId value, std::vector<StmtId>& result) {
        if (!is_narrowed(stmt)) return false;
        result.push_back(narrowed(stmt, value));
        return true;
    };
    return rebuilt(cx, body, visited, take);
}

}  // namespace

std::vector<StmtId> narrow_loads(Context& cx, const std::vector<StmtId>& body) {
    Narrowing narrowing(cx);
    narrowing.count(body);
    return narrowing.run(body);
}

}  // namespace gliftc::lower
