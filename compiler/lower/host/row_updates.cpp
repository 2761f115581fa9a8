#include "lower/host/row_updates.h"

#include "ir/walk.h"
#include "lower/analysis/number.h"
#include "lower/analysis/slopes.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

class RowUpdates {
public:
    explicit RowUpdates(Context& context) : cx(context), numbers_(context), slopes_(context.p, context.pass.address) {}

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        for (StmtId id : body) result.push_back(run(id));
        return result;
    }

private:
    StmtId run(StmtId id) {
        Stmt stmt = cx.p.stmts[id];
        slopes_.learn(stmt);
        if (stmt.op == StmtOp::atomic && is_of_column(stmt)) {
            stmt.op = StmtOp::column_update;
            stmt.limit = cx.build.component(cx.build.local(cx.pass.address), 0);
            return cx.add(std::move(stmt));
        }
        if (stmt.op == StmtOp::atomic && is_of_row(stmt)) {
            stmt.op = StmtOp::row_update;
            return cx.add(std::move(stmt));
        }
        if (stmt.body.empty() && stmt.otherwise.empty()) return id;
        return cx.build.again(id, {stmt.target, stmt.value, stmt.limit, run(stmt.body), run(stmt.otherwise)});
    }

    bool is_of_column(const Stmt& update) const {
        const PassUpdate* ordered = cx.pass.ordered_sum(update.slot);
        return ordered != nullptr && ordered->order->axis != 0;
    }

    bool is_of_row(const Stmt& update) {
        if (cx.pass.ordered_sum(update.slot) != nullptr) return true;
        return is_combined_by_threads(cx.p.types, cx.pass.bindings[update.slot], cx.pass.is_wide) &&
               numbers_.is_fixed(update.target) && slopes_.is_steady(update.target);
    }

    Context& cx;
    Numbers numbers_;
    RowSlopes slopes_;
};

/// Whether elements depend on one another, or on their order, by other statements than row updates.
bool is_ordered(const Context& cx, const std::vector<StmtId>& body) {
    bool is_ordered = std::ranges::any_of(
        cx.pass.bindings, [](const PassBinding& binding) { return binding.coherent && !binding.is_workspace; });
    const auto note = [&](const Stmt& stmt) { is_ordered = is_ordered || stmt.op == StmtOp::atomic; };
    for_each_statement(cx.p, body, note);
    for (const auto& [key, function] : cx.instances) for_each_statement(cx.p, cx.p.functions[function].body, note);
    return is_ordered;
}

}  // namespace

void find_row_updates(Context& cx, Variant& variant) {
    const bool has_updates = std::ranges::any_of(cx.pass.bindings, &PassBinding::atomic);
    if (!has_updates || variant.block) return;
    variant.body = RowUpdates(cx).run(variant.body);
    if (!is_ordered(cx, variant.body)) variant.order = RowOrder::any;
}

}  // namespace gliftc::lower
