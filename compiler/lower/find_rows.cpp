#include "lower/find_rows.h"

#include "ir/walk.h"
#include "lower/rewrite.h"
#include "lower/slopes.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace gliftc::lower {

using namespace ir;

namespace {

bool has_return(const Program& program, const std::vector<StmtId>& body) {
    bool found = false;
    for_each_statement(program, body, [&](const Stmt& stmt) { found = found || stmt.op == StmtOp::return_; });
    return found;
}

/// Whether all operands are evaluated, not the first alone.
bool evaluates_all(const Expr& node) {
    const bool is_logical = node.binary == BinaryOp::logical_and || node.binary == BinaryOp::logical_or;
    return node.op != Op::select && (node.op != Op::binary || !is_logical);
}

/// What is known before the body: values of the block are the same for all its elements.
RowSlopes slopes_of(const Context& cx, const Variant& variant) {
    RowSlopes slopes(cx.p, cx.pass.address);
    if (!variant.block) return slopes;
    for (StmtId id : *variant.block)
        if (cx.p.stmts[id].op == StmtOp::let) slopes.learn_steady(cx.p.stmts[id].local);
    return slopes;
}

/// A binding and an index in it.
using RowPlace = std::pair<std::uint32_t, ExprId>;

/// Places that every element of a row comes by, in the order of memory. Ends at the first early return: what follows is
/// not executed by every element.
class Finder {
public:
    Finder(const Context& context, const Variant& variant) : cx(context), slopes_(slopes_of(context, variant)) {}

    void walk(const std::vector<StmtId>& body) {
        for (StmtId id : body)
            if (all_come_by_) visit(cx.p.stmts[id]);
    }
    std::set<RowPlace> places;

private:
    void visit(const Stmt& stmt) {
        if (stmt.op == StmtOp::block) return walk(stmt.body);
        if (stmt.value) visit(stmt.value);
        if (stmt.op == StmtOp::store) note(stmt.slot, stmt.target, cx.p.exprs[stmt.value].type);
        const bool may_return = has_return(cx.p, stmt.body) || has_return(cx.p, stmt.otherwise);
        all_come_by_ = stmt.op != StmtOp::return_ && !may_return;
        slopes_.learn(stmt);
    }

    void visit(ExprId id) {
        const Expr& node = cx.p.exprs[id];
        if (node.op == Op::load && note(node.slot, node.operands[0], node.type)) return;
        for (std::size_t i = 0; i < node.operands.size() && (i == 0 || evaluates_all(node)); ++i)
            visit(node.operands[i]);
    }

    bool note(std::uint32_t binding, ExprId index, TypeId type) {
        if (is_row(cx.p.types, cx.pass.bindings[binding], type) || !slopes_.is_row(index)) return false;
        places.insert({binding, index});
        return true;
    }

    const Context& cx;
    RowSlopes slopes_;
    bool all_come_by_ = true;
};

/// The statements with accesses of rows at the places.
class Marking {
public:
    Marking(Context& context, const std::set<RowPlace>& places) : cx(context), places_(places) {}

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        result.reserve(body.size());
        for (StmtId id : body) result.push_back(visited(id));
        return result;
    }

private:
    StmtId visited(StmtId id) {
        const Stmt& stmt = cx.p.stmts[id];
        Make::Parts parts = visited_parts(stmt, [&](ExprId part) { return visited(part); });
        if (stmt.op == StmtOp::store && is_marked(stmt.slot, stmt.target, cx.p.exprs[stmt.value].type)) {
            Stmt copy = stmt;
            copy.op = StmtOp::row_store;
            copy.value = parts.value;
            return cx.add(std::move(copy));
        }
        parts.body = run(stmt.body);
        parts.otherwise = run(stmt.otherwise);
        return cx.make.again(id, std::move(parts));
    }

    ExprId visited(ExprId id) {
        const Expr& node = cx.p.exprs[id];
        if (node.op == Op::load && is_marked(node.slot, node.operands[0], node.type)) {
            Expr copy = node;
            copy.op = Op::row_load;
            return cx.p.exprs.add(std::move(copy));
        }
        return with_operands_visited(cx, id, [&](ExprId operand) { return visited(operand); });
    }

    bool is_marked(std::uint32_t binding, ExprId index, TypeId type) const {
        return places_.contains({binding, index}) && !is_row(cx.p.types, cx.pass.bindings[binding], type);
    }

    Context& cx;
    const std::set<RowPlace>& places_;
};

/// With the accesses of rows that are found in it, if there are any.
std::optional<std::vector<StmtId>> marked(Context& cx, const Variant& variant, const std::vector<StmtId>& body) {
    Finder finder(cx, variant);
    finder.walk(body);
    if (finder.places.empty()) return std::nullopt;
    return Marking(cx, finder.places).run(body);
}

bool is_clamp(const Program& program, const Expr& node) {
    return node.op == Op::intrinsic && node.type == program.types.int_ &&
           (node.intrinsic == Intrinsic::clamp || node.intrinsic == Intrinsic::min || node.intrinsic == Intrinsic::max);
}

/// Calls of clamp, min and max on a signed integer that advances by one along the row: in the middle of the row they
/// change nothing, whatever translator they come from.
std::set<ExprId> row_clamps(const Context& cx, const Variant& variant) {
    const std::vector<StmtId>& body = variant.body;
    std::set<ExprId> clamps;
    for_each_expression_of_trees(cx.p, body, [&](ExprId id) {
        if (is_clamp(cx.p, cx.p.exprs[id])) clamps.insert(id);
    });
    if (clamps.empty()) return clamps;
    RowSlopes slopes = slopes_of(cx, variant);
    for (StmtId id : body) slopes.learn(cx.p.stmts[id]);
    std::erase_if(clamps, [&](ExprId id) {
        const Operands& operands = cx.p.exprs[id].operands;
        bool is_known = slopes.is_row(operands[0]);
        for (std::size_t i = 1; i < operands.size(); ++i) is_known = is_known && slopes.is_steady(operands[i]);
        return !is_known;
    });
    return clamps;
}

/// What holds where a clamp changes nothing.
Bounds bounds_of(const Expr& clamp) {
    const Operands& operands = clamp.operands;
    if (clamp.intrinsic == Intrinsic::clamp) return {operands[0], operands[1], operands[2]};
    return clamp.intrinsic == Intrinsic::min ? Bounds{operands[0], {}, operands[1]}
                                             : Bounds{operands[0], operands[1], {}};
}

/// The statements with the first operand in place of each clamp.
class Unclamping {
public:
    Unclamping(Context& context, const std::set<ExprId>& identities) : cx(context), clamps_(identities) {}

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        result.reserve(body.size());
        for (StmtId id : body) {
            const Stmt& stmt = cx.p.stmts[id];
            Make::Parts parts = visited_parts(stmt, [&](ExprId part) { return visited(part); });
            parts.body = run(stmt.body);
            parts.otherwise = run(stmt.otherwise);
            result.push_back(cx.make.again(id, std::move(parts)));
        }
        return result;
    }

private:
    ExprId visited(ExprId id) {
        if (clamps_.contains(id)) return visited(cx.p.exprs[id].operands[0]);
        return with_operands_visited(cx, id, [&](ExprId operand) { return visited(operand); });
    }

    Context& cx;
    const std::set<ExprId>& clamps_;
};

bool is_independent(const Context& cx, const std::vector<StmtId>& body) {
    bool is_atomic = false;
    for_each_statement(cx.p, body, [&](const Stmt& stmt) { is_atomic = is_atomic || stmt.op == StmtOp::atomic; });
    return !is_atomic && std::ranges::none_of(cx.pass.bindings, [](const PassBinding& binding) {
        return binding.atomic || binding.coherent;
    });
}

/// Whether no memory is read that is written, and nothing but memory is changed; and all elements do the same, so that
/// doing some twice pays.
bool may_be_repeated(const Context& cx, const std::vector<StmtId>& body) {
    for (std::uint32_t i = 0; i < cx.pass.bindings.size(); ++i)
        if (cx.pass.bindings[i].access == Access::read_write || cx.pass.bindings[i].one_place != i) return false;
    bool is_straight = true;
    for_each_statement(cx.p, body, [&](const Stmt& stmt) {
        is_straight = is_straight && (stmt.op == StmtOp::let || stmt.op == StmtOp::assign || stmt.op == StmtOp::store ||
                                      stmt.op == StmtOp::row_store || stmt.op == StmtOp::block);
    });
    return is_straight;
}

RowOrder order_of(const Context& cx, const Variant& variant) {
    if (!is_independent(cx, variant.body)) return RowOrder::ascending;
    const bool is_of_middle = variant.assumes.interior || !variant.assumes.bounds.empty();
    return is_of_middle && may_be_repeated(cx, variant.body) ? RowOrder::in_blocks : RowOrder::any;
}

/// For where the clamps change nothing; none if that makes no access one of a row.
std::optional<Variant> unclamped(Context& cx, const Variant& variant) {
    const std::set<ExprId> clamps = row_clamps(cx, variant);
    if (clamps.empty()) return std::nullopt;
    std::optional<std::vector<StmtId>> body = marked(cx, variant, Unclamping(cx, clamps).run(variant.body));
    if (!body) return std::nullopt;
    Variant made{Part::whole, Devices::host, variant.assumes, std::move(*body), variant.block};
    for (ExprId clamp : clamps) made.assumes.bounds.push_back(bounds_of(cx.p.exprs[clamp]));
    made.order = order_of(cx, made);
    return made;
}

}  // namespace

std::vector<Variant> find_rows(Context& cx, const Variant& variant) {
    std::optional<Variant> middle = unclamped(cx, variant);
    std::optional<std::vector<StmtId>> body = marked(cx, variant, variant.body);
    Variant whole{Part::whole, Devices::host, variant.assumes, body ? std::move(*body) : variant.body, variant.block};
    whole.order = order_of(cx, whole);
    if (whole.order == RowOrder::in_blocks && (middle || !body)) whole.order = RowOrder::any;
    std::vector<Variant> result{std::move(whole)};
    if (middle) result.push_back(std::move(*middle));
    return result;
}

}  // namespace gliftc::lower
