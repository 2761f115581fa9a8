#include "lower/host/find_rows.h"

#include "ir/walk.h"
#include "lower/analysis/slopes.h"
#include "lower/build/rewrite.h"
#include "lower/transform/dead.h"

#include <algorithm>
#include <map>
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

/// Whether all operands are always evaluated, not only the first one.
bool evaluates_all(const Expr& node) {
    const bool is_logical = node.binary == BinaryOp::logical_and || node.binary == BinaryOp::logical_or;
    return node.op != Op::select && (node.op != Op::binary || !is_logical);
}

/// The slopes that are known before the body: in kernels over blocks, values that are computed once a block are
/// constant along a row.
RowSlopes slopes_of(const Context& cx, const Variant& variant) {
    RowSlopes slopes(cx.p, cx.pass.address, variant.assumes.row);
    if (!variant.block) return slopes;
    for (StmtId id : *variant.block)
        if (cx.p.stmts[id].op == StmtOp::let) slopes.learn_steady(cx.p.stmts[id].local);
    return slopes;
}

/// A binding and an index in it.
using RowPlace = std::pair<std::uint32_t, ExprId>;

/// The accesses that become row accesses.
struct RowPlaces {
    std::set<RowPlace> memory;
    std::set<ExprId> items;  ///< Op::index nodes: elements of arrays that are filled once a block
};

/// Finds accesses that every element of a row executes, at an index that advances by one from element to element. Stops
/// at the first statement that may return: not every element executes what follows it.
class Finder {
public:
    Finder(const Context& context, const Variant& variant)
        : cx(context), slopes_(slopes_of(context, variant)), in_lockstep_(is_in_lockstep(context.p, variant.body)) {
        if (!variant.block) return;
        for (StmtId id : *variant.block) {
            const Stmt& stmt = cx.p.stmts[id];
            if (stmt.op == StmtOp::let && stmt.uninitialized) arrays_.insert(stmt.local);
        }
    }

    void walk(const std::vector<StmtId>& body) {
        for (StmtId id : body)
            if (all_come_by_) visit(cx.p.stmts[id]);
    }
    RowPlaces places;

private:
    void visit(const Stmt& stmt) {
        if (stmt.op == StmtOp::block) return walk(stmt.body);
        if (in_lockstep_) return visit_of_run(stmt);
        visit_of_element(stmt);
    }

    /// In lockstep, a row is a run of elements. Within `invocations`, values that are kept may be any; outside of them,
    /// all are the same for the run.
    void visit_of_run(const Stmt& stmt) {
        if (stmt.op == StmtOp::keep) kept_.insert(stmt.local);
        if (is_element_) {
            if (stmt.op != StmtOp::let || !kept_.contains(stmt.local)) return visit_of_element(stmt);
            if (stmt.value) visit(stmt.value);
            return;
        }
        if (stmt.op == StmtOp::let || stmt.op == StmtOp::for_) slopes_.learn_steady(stmt.local);
        is_element_ = stmt.op == StmtOp::invocations;
        walk(stmt.body);
        is_element_ = false;
    }

    void visit_of_element(const Stmt& stmt) {
        if (stmt.value) visit(stmt.value);
        if (stmt.op == StmtOp::if_ && slopes_.is_steady(stmt.value) && stmt.otherwise.empty()) visit_inside(stmt.body);
        if (stmt.op == StmtOp::store) note(stmt.slot, stmt.target, cx.p.exprs[stmt.value].type);
        const bool may_return = has_return(cx.p, stmt.body) || has_return(cx.p, stmt.otherwise);
        all_come_by_ = stmt.op != StmtOp::return_ && !may_return;
        slopes_.learn(stmt);
    }

    /// The statements of an if that all elements of the row execute, or none. What they access by an index that is
    /// computed before the if is an access of the row.
    void visit_inside(const std::vector<StmtId>& body) {
        for (StmtId id : body) {
            const Stmt& stmt = cx.p.stmts[id];
            if (stmt.op == StmtOp::let) inner_.insert(stmt.local);
            if (stmt.value && (stmt.op == StmtOp::let || stmt.op == StmtOp::assign || stmt.op == StmtOp::atomic))
                visit(stmt.value);
        }
    }

    bool is_inner(ExprId index) const {
        bool found = false;
        for_each_node(cx.p, index, [&](ExprId id) {
            const Expr& node = cx.p.exprs[id];
            found = found || (node.op == Op::local && inner_.contains(node.local));
        });
        return found;
    }

    void visit(ExprId id) {
        const Expr& node = cx.p.exprs[id];
        if (node.op == Op::load && note(node.slot, node.operands[0], node.type)) return;
        if (node.op == Op::index && is_of_block(node.operands[0]) && slopes_.is_row(node.operands[1])) {
            places.items.insert(id);
            return;
        }
        for (std::size_t i = 0; i < node.operands.size() && (i == 0 || evaluates_all(node)); ++i)
            visit(node.operands[i]);
    }

    bool note(std::uint32_t binding, ExprId index, TypeId type) {
        if (is_row(cx.p.types, cx.pass.bindings[binding], type)) return false;
        const bool is_read = cx.pass.bindings[binding].access == Access::read;
        if (!slopes_.is_row(index) && !(is_read && is_choice_of_row(index))) return false;
        if (is_inner(index)) return false;
        places.memory.insert({binding, index});
        return true;
    }

    /// In lockstep: whether the index is one that advances by one, or else one that is the same for the run, as a
    /// condition says that is the same for the run.
    bool is_choice_of_row(ExprId index) {
        const Expr& node = cx.p.exprs[index];
        return is_element_ && node.op == Op::select && slopes_.is_steady(node.operands[0]) &&
               slopes_.is_row(node.operands[1]) && slopes_.is_steady(node.operands[2]);
    }

    /// Whether the array is one that is filled once a block. Indices of such an array are in bounds, as row_item needs.
    bool is_of_block(ExprId array) const {
        const Expr& node = cx.p.exprs[array];
        return node.op == Op::local && arrays_.contains(node.local);
    }

    const Context& cx;
    RowSlopes slopes_;
    IdSet<Local> arrays_;
    IdSet<Local> kept_;   ///< in lockstep
    IdSet<Local> inner_;  ///< locals that ifs declare
    bool in_lockstep_ = false;
    bool is_element_ = false;  ///< in lockstep: within `invocations`
    bool all_come_by_ = true;
};

/// Replaces the accesses that were found by row accesses.
class Marking {
public:
    Marking(Context& context, const RowPlaces& places) : cx(context), places_(places) {}

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        result.reserve(body.size());
        for (StmtId id : body) result.push_back(visited(id));
        return result;
    }

private:
    StmtId visited(StmtId id) {
        const Stmt& stmt = cx.p.stmts[id];
        Builder::Parts parts = visited_parts(stmt, [&](ExprId part) { return visited(part); });
        if (stmt.op == StmtOp::store && is_marked(stmt.slot, stmt.target, cx.p.exprs[stmt.value].type)) {
            Stmt copy = stmt;
            copy.op = StmtOp::row_store;
            copy.value = parts.value;
            return cx.add(std::move(copy));
        }
        parts.body = run(stmt.body);
        parts.otherwise = run(stmt.otherwise);
        return cx.build.again(id, std::move(parts));
    }

    ExprId visited(ExprId id) {
        const Expr& node = cx.p.exprs[id];
        if (node.op == Op::load && is_marked(node.slot, node.operands[0], node.type)) {
            Expr copy = node;
            copy.op = Op::row_load;
            return cx.p.exprs.add(std::move(copy));
        }
        if (places_.items.contains(id)) {
            Expr copy = node;
            copy.op = Op::row_item;
            return cx.p.exprs.add(std::move(copy));
        }
        return with_operands_visited(cx, id, [&](ExprId operand) { return visited(operand); });
    }

    bool is_marked(std::uint32_t binding, ExprId index, TypeId type) const {
        return places_.memory.contains({binding, index}) && !is_row(cx.p.types, cx.pass.bindings[binding], type);
    }

    Context& cx;
    const RowPlaces& places_;
};

/// The body with row accesses; none if there are no such accesses.
std::optional<std::vector<StmtId>> marked(Context& cx, const Variant& variant, const std::vector<StmtId>& body) {
    Finder finder(cx, variant);
    finder.walk(body);
    if (finder.places.memory.empty() && finder.places.items.empty()) return std::nullopt;
    return Marking(cx, finder.places).run(body);
}

bool is_clamp(const Program& program, const Expr& node) {
    if (node.op != Op::intrinsic) return false;
    if (node.type == program.types.uint) return node.intrinsic == Intrinsic::min;
    return node.type == program.types.int_ &&
           (node.intrinsic == Intrinsic::clamp || node.intrinsic == Intrinsic::min || node.intrinsic == Intrinsic::max);
}

/// Whether the node is x < n ? y : … of uints, as in translators that map addresses beyond the border back inside (in
/// these, y is x).
bool is_choice_of_inside(const Program& program, const Expr& node) {
    if (node.op != Op::select || node.type != program.types.uint) return false;
    const Expr& condition = program.exprs[node.operands[0]];
    return condition.op == Op::binary && condition.binary == BinaryOp::less &&
           program.exprs[condition.operands[0]].type == program.types.uint;
}

/// Maps operations that change nothing in the middle of a row to the operand that each equals there. They are clamp,
/// min and max of an int x, and min of a uint x, where x advances by one along the row and the limits are constant
/// along it; and x < n ? y : … of uints, where x and y advance by one and n is constant.
using Identities = std::map<ExprId, ExprId>;

Identities row_identities(const Context& cx, const Variant& variant, const std::vector<StmtId>& body) {
    Identities found;
    for_each_expression_of_trees(cx.p, body, [&](ExprId id) {
        const Expr& node = cx.p.exprs[id];
        if (is_clamp(cx.p, node)) found.emplace(id, node.operands[0]);
        else if (is_choice_of_inside(cx.p, node)) found.emplace(id, node.operands[1]);
    });
    if (found.empty()) return found;
    RowSlopes slopes = slopes_of(cx, variant);
    for (StmtId id : body) slopes.learn(cx.p.stmts[id]);
    std::erase_if(found, [&](const auto& identity) {
        const Expr& node = cx.p.exprs[identity.first];
        const bool is_choice = node.op == Op::select;
        const Operands& operands = is_choice ? cx.p.exprs[node.operands[0]].operands : node.operands;
        bool is_known = slopes.is_row(operands[0]) && slopes.is_row(identity.second);
        for (std::size_t i = 1; i < operands.size(); ++i) is_known = is_known && slopes.is_steady(operands[i]);
        return !is_known;
    });
    return found;
}

/// The bounds of the operation's operand within which the operation changes nothing.
Bounds bounds_of(Context& cx, const Expr& identity) {
    const Operands& operands = identity.operands;
    const TypeId signed_type = cx.p.types.int_;
    const auto as_signed = [&](ExprId id) { return cx.build.convert(signed_type, id); };
    const ExprId zero = cx.build.integer(signed_type, 0);
    if (identity.op == Op::select) {
        const Operands compared = cx.p.exprs[operands[0]].operands;
        const ExprId last =
            cx.build.binary(BinaryOp::subtract, as_signed(compared[1]), cx.build.integer(signed_type, 1));
        return {as_signed(compared[0]), zero, last};
    }
    if (identity.type == cx.p.types.uint) return {as_signed(operands[0]), zero, as_signed(operands[1])};
    if (identity.intrinsic == Intrinsic::clamp) return {operands[0], operands[1], operands[2]};
    return identity.intrinsic == Intrinsic::min ? Bounds{operands[0], {}, operands[1]}
                                                : Bounds{operands[0], operands[1], {}};
}

/// Replaces each operation of `identities` by the operand that it equals in the middle of a row.
class Unclamping {
public:
    Unclamping(Context& context, const Identities& identities) : cx(context), identities_(identities) {}

    std::vector<StmtId> run(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        result.reserve(body.size());
        for (StmtId id : body) {
            const Stmt& stmt = cx.p.stmts[id];
            Builder::Parts parts = visited_parts(stmt, [&](ExprId part) { return visited(part); });
            parts.body = run(stmt.body);
            parts.otherwise = run(stmt.otherwise);
            result.push_back(cx.build.again(id, std::move(parts)));
        }
        return result;
    }

private:
    ExprId visited(ExprId id) {
        if (const auto found = identities_.find(id); found != identities_.end()) return visited(found->second);
        return with_operands_visited(cx, id, [&](ExprId operand) { return visited(operand); });
    }

    Context& cx;
    const Identities& identities_;
};

bool is_independent(const Context& cx, const std::vector<StmtId>& body) {
    bool is_atomic = false;
    for_each_statement(cx.p, body, [&](const Stmt& stmt) { is_atomic = is_atomic || stmt.op == StmtOp::atomic; });
    return !is_atomic && std::ranges::none_of(cx.pass.bindings, [](const PassBinding& binding) {
        return binding.atomic || binding.coherent;
    });
}

/// Whether elements may be executed twice, and whether that pays: no binding is both read and written, no two bindings
/// may alias, and the body is straight-line code.
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

/// The variant for elements for which clamps change nothing; none if there are no clamps, or if it would have no row
/// accesses.
std::optional<Variant> unclamped(Context& cx, const Variant& variant) {
    std::vector<StmtId> body = variant.body;
    Variant made{Part::whole, Devices::host, variant.assumes, {}, variant.block};
    // Twice, for values that are clamped on one side and then on the other.
    for (int round = 0; round < 2; ++round) {
        const Identities identities = row_identities(cx, variant, body);
        for (const auto& [identity, inner] : identities)
            made.assumes.bounds.push_back(bounds_of(cx, Expr(cx.p.exprs[identity])));
        body = Unclamping(cx, identities).run(body);
    }
    if (made.assumes.bounds.size() == variant.assumes.bounds.size()) return std::nullopt;
    std::optional<std::vector<StmtId>> rows = marked(cx, variant, body);
    if (!rows) return std::nullopt;
    made.body = drop_dead(cx, *rows);
    made.order = order_of(cx, made);
    return made;
}

}  // namespace

std::vector<Variant> find_rows(Context& cx, const Variant& variant) {
    std::optional<Variant> middle = is_in_lockstep(cx.p, variant.body) ? std::nullopt : unclamped(cx, variant);
    std::optional<std::vector<StmtId>> body = marked(cx, variant, variant.body);
    Variant whole{Part::whole, Devices::host, variant.assumes, body ? std::move(*body) : variant.body, variant.block};
    whole.order = order_of(cx, whole);
    if (whole.order == RowOrder::in_blocks && (middle || !body)) whole.order = RowOrder::any;
    std::vector<Variant> result{std::move(whole)};
    if (middle) result.push_back(std::move(*middle));
    return result;
}

}  // namespace gliftc::lower
