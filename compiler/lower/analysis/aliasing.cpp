#include "lower/analysis/aliasing.h"

#include "ir/effects.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

std::uint32_t first_of_place(const Context& cx, const PassBinding& binding) {
    const auto& bindings = cx.pass.bindings;
    const auto same = [&](const PassBinding& other) { return may_be_one_place(cx.p, cx.kernel, other, binding); };
    const auto first = cx.is_direct() ? bindings.end() : std::ranges::find_if(bindings, same);
    return static_cast<std::uint32_t>(first - bindings.begin());
}

bool may_be_written_elsewhere(const Context& cx, std::uint32_t root) {
    const KernelParam& param = cx.kernel.params[root];
    if (cx.is_direct() || traits_of(param.pattern).reach != Reach::element) return false;
    return std::ranges::any_of(cx.kernel.params, [&](const KernelParam& other) {
        return &other != &param && other.structure == param.structure && other.direction != Direction::in &&
               traits_of(other.pattern).reach == Reach::element;
    });
}

namespace {

/// Walks a body in order. In a loop all stores count as coming before all loads, because of the next iteration.
class Order {
public:
    Order(const Program& program, const Pass& pass, std::uint32_t place) : p(program), pass_(pass), place_(place) {}

    bool loads_after_store(const std::vector<StmtId>& body) {
        for (StmtId id : body) visit(p.stmts[id]);
        return found_;
    }

private:
    bool is_place(std::uint32_t slot) const { return pass_.bindings[slot].one_place == place_; }

    void visit(const Stmt& stmt) {
        if (stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_)
            for_each_statement(p, stmt.body, [&](const Stmt& inner) { note_store(inner); });
        for_each_root(stmt, [&](ExprId root) {
            for_each_node(p, root, [&](ExprId id) {
                const Expr& node = p.exprs[id];
                const bool is_load = node.op == Op::load || node.op == Op::image_load;
                found_ = found_ || (stored_ && is_load && is_place(node.slot));
            });
        });
        for (StmtId id : stmt.body) visit(p.stmts[id]);
        for (StmtId id : stmt.otherwise) visit(p.stmts[id]);
        note_store(stmt);
    }
    void note_store(const Stmt& stmt) {
        stored_ = stored_ || ((stmt.op == StmtOp::store || stmt.op == StmtOp::image_store) && is_place(stmt.slot));
    }

    const Program& p;
    const Pass& pass_;
    std::uint32_t place_;
    bool stored_ = false, found_ = false;
};

}  // namespace

bool loads_after_store(const Program& program, const Pass& pass, std::uint32_t place) {
    return Order(program, pass, place).loads_after_store(pass.plain().body);
}

}  // namespace gliftc::lower
