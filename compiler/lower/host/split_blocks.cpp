#include "lower/host/split_blocks.h"
#include "lower/analysis/block_values.h"

#include "ir/walk.h"
#include "lower/expand/blocks.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

/// Finds arrays that depend on the visited block alone: they are assigned only in compound statements (StmtOp::block)
/// whose loops, conditions and values depend on the visited block alone.
class Filling {
public:
    Filling(Context& context, const std::vector<StmtId>& body) : cx(context), values_(context) {
        for (StmtId id : body) {
            const Stmt& stmt = cx.p.stmts[id];
            values_.has(stmt);
            if (stmt.op == StmtOp::block && are_of_block(stmt.body)) statements_.push_back(id);
        }
        for (StmtId id : body) {
            const Stmt& stmt = cx.p.stmts[id];
            // The declaration of a mutable local that is given a value, or zeroed, stays in the body; so what assigns
            // the local must stay there, too.
            if (stmt.op == StmtOp::let && !stmt.uninitialized) others_.insert(stmt.local);
            if (!fills(id)) note_assigned(id);
        }
        while (leave_out_others()) {}
    }

    /// Whether the statement declares such an array, or is a compound statement that fills only such arrays.
    bool has(StmtId id) const {
        const Stmt& stmt = cx.p.stmts[id];
        if (stmt.op == StmtOp::let)
            return stmt.uninitialized && filled_.contains(stmt.local) && !others_.contains(stmt.local);
        return fills(id);
    }

private:
    bool fills(StmtId id) const { return std::ranges::find(statements_, id) != statements_.end(); }

    void note_assigned(StmtId id) {
        for_each_statement(cx.p, {id}, [&](const Stmt& stmt) {
            if (stmt.op == StmtOp::assign) others_.insert(place_of(cx.p, stmt.target).local);
        });
    }

    /// Removes from statements_ a compound statement that assigns an array of others_, and adds all arrays that it
    /// assigns to others_; false if there is none.
    bool leave_out_others() {
        const auto found = std::ranges::find_if(statements_, [&](StmtId id) {
            bool assigns_other = false;
            for_each_statement(cx.p, {id}, [&](const Stmt& stmt) {
                assigns_other =
                    assigns_other || (stmt.op == StmtOp::assign && others_.contains(place_of(cx.p, stmt.target).local));
            });
            return assigns_other;
        });
        if (found == statements_.end()) return false;
        note_assigned(*found);
        statements_.erase(found);
        return true;
    }

    bool are_of_block(const std::vector<StmtId>& body) {
        return std::ranges::all_of(body, [&](StmtId id) { return is_of_block(cx.p.stmts[id]); });
    }

    bool is_of_block(const Stmt& stmt) {
        if (stmt.op == StmtOp::let) return values_.has(stmt);
        if (stmt.op == StmtOp::assign) return is_item(stmt.target) && values_.has(stmt.value);
        if (stmt.op != StmtOp::for_ && stmt.op != StmtOp::if_) return false;
        return values_.has(stmt.value) && (!stmt.limit || values_.has(stmt.limit)) && are_of_block(stmt.body) &&
               are_of_block(stmt.otherwise);
    }

    bool is_item(ExprId target) {
        const Expr& index = cx.p.exprs[target];
        if (index.op != Op::index || cx.p.exprs[index.operands[0]].op != Op::local) return false;
        filled_.insert(cx.p.exprs[index.operands[0]].local);
        return values_.has(index.operands[1]);
    }

    Context& cx;
    BlockValues values_;
    std::vector<StmtId> statements_;  ///< compound statements that fill only such arrays
    IdSet<Local> filled_, others_;    ///< arrays assigned in such statements; locals that stay in the body
};

}  // namespace

std::optional<Variant> split_blocks(Context& cx, const Variant& variant) {
    Variant made = variant;
    made.body.clear();
    made.block.emplace();
    BlockValues values(cx);
    const Filling filling(cx, variant.body);
    StmtId holds;
    for (StmtId id : variant.body) {
        const Stmt& stmt = cx.p.stmts[id];
        const bool is_condition =
            !holds && stmt.op == StmtOp::evaluate && cx.build.type(stmt.value) == cx.p.types.bool_;
        if (is_condition && !values.has(stmt.value)) return std::nullopt;
        if (is_condition) holds = id;
        const bool is_of_block = is_condition || values.has(stmt) || filling.has(id);
        (is_of_block ? *made.block : made.body).push_back(id);
    }
    if (!holds) return std::nullopt;
    return made;
}

}  // namespace gliftc::lower
