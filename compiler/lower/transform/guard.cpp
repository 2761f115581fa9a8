#include "lower/transform/guard.h"

#include "ir/levels.h"
#include "ir/walk.h"
#include "lower/build/rewrite.h"
#include "lower/expand/memory.h"

#include <utility>

namespace gliftc::lower {

using namespace ir;

namespace {

/// The operands of a guarded_load.
struct Guarded {
    std::uint32_t binding;
    ExprId condition, at, safe, otherwise;
};

class Guarding {
public:
    Guarding(Context& context, const std::vector<StmtId>& body) : cx(context) {
        for_each_expression_of_trees(cx.p, body, [&](ExprId id) {
            if (cx.p.exprs[id].op == Op::local) ++uses_[cx.p.exprs[id].local];
        });
    }

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        result.reserve(body.size());
        std::vector<StmtId>* outer = std::exchange(out_, &result);
        for (StmtId id : body) statement_(id);
        out_ = outer;
        return result;
    }

private:
    void statement_(StmtId id) {
        const Stmt& stmt = cx.p.stmts[id];
        if (stmt.op == StmtOp::let && stmt.value && cx.p.exprs[stmt.value].op == Op::guarded_load) return load(stmt);
        Builder::Parts parts = visited_parts(stmt, [&](ExprId part) { return visit(part); });
        parts.body = run(stmt.body);
        parts.otherwise = run(stmt.otherwise);
        out_->push_back(cx.build.again(id, std::move(parts)));
    }

    void load(const Stmt& let) {
        const Expr& node = cx.p.exprs[let.value];
        const Guarded guarded{node.slot, visit(node.operands[0]), visit(node.operands[1]), visit(node.operands[2]),
                              visit(node.operands[3])};
        const Types& types = cx.p.types;
        if (cx.build.is_true(guarded.condition)) return declare(let, load_from(cx, guarded.binding, guarded.at));
        if (cx.build.is_false(guarded.condition)) return declare(let, guarded.otherwise);
        const bool is_choice = !cx.kernel.grouped() && (types.is_scalar(node.type) || types.is_vector(node.type));
        is_choice ? load_and_choose(let, guarded) : load_in_branch(let, guarded);
    }

    void load_and_choose(const Stmt& let, const Guarded& guarded) {
        const ExprId address = cx.build.select(guarded.condition, guarded.at, guarded.safe);
        declare(let, load_from(cx, guarded.binding, address));
        const ExprId chosen = cx.build.select(guarded.condition, cx.build.local(let.local), guarded.otherwise);
        values_[let.local] = uses_[let.local] > 1 ? temporary(let, chosen) : chosen;
    }

    ExprId temporary(const Stmt& let, ExprId value) {
        const Local local = cx.p.locals[let.local];
        Stmt named = let;
        named.local = cx.new_local(name_of(let), local.type, local.span);
        cx.p.locals[named.local].is_temporary = true;
        const ExprId result = cx.build.local(named.local);
        declare(named, value);
        return result;
    }

    /// The name that Context::names has for the value, else that of the local.
    Name name_of(const Stmt& let) const {
        const Name* in_source = cx.names.find(let.value);
        return in_source != nullptr ? *in_source : cx.p.locals[let.local].name;
    }

    void load_in_branch(const Stmt& let, const Guarded& guarded) {
        const Local local = cx.p.locals[let.local];
        Stmt variable = let;
        variable.local = cx.new_local(name_of(let), local.type, local.span, true);
        variable.value = guarded.otherwise;
        const ExprId value = cx.build.local(variable.local);
        values_[let.local] = value;
        out_->push_back(cx.add(std::move(variable)));
        Stmt assign = statement(StmtOp::assign, let.span);
        assign.target = value;
        assign.value = load_from(cx, guarded.binding, guarded.at);
        Stmt branch = statement(StmtOp::if_, let.span);
        branch.value = guarded.condition;
        branch.body = {cx.add(std::move(assign))};
        out_->push_back(cx.add(std::move(branch)));
    }

    void declare(const Stmt& let, ExprId value) {
        Stmt made = let;
        made.value = value;
        cx.definitions[let.local] = value;
        out_->push_back(cx.add(std::move(made)));
    }

    /// The expression with the new values in place of locals that held guarded loads.
    ExprId visit(ExprId id) {
        const Expr node = cx.p.exprs[id];
        if (node.op == Op::guarded_load) misplaced(node.op, "guard");
        if (node.op == Op::local) {
            const ExprId* found = values_.find(node.local);
            return found == nullptr ? id : *found;
        }
        Operands operands;
        for (ExprId operand : node.operands) operands.push_back(visit(operand));
        if (operands == node.operands) return id;
        const ExprId made = cx.build.again(node, std::move(operands));
        if (const Name* name = cx.names.find(id)) cx.names.emplace(made, Name{*name});
        return made;
    }

    Context& cx;
    NodeMap<LocalId, unsigned> uses_{cx.first_local};
    NodeMap<LocalId, ExprId> values_{cx.first_local};  ///< replacements of the locals that held guarded loads
    std::vector<StmtId>* out_ = nullptr;
};

}  // namespace

std::vector<StmtId> guard(Context& cx, const std::vector<StmtId>& body) { return Guarding(cx, body).run(body); }

}  // namespace gliftc::lower
