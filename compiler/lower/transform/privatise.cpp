// long: one transformation, whose steps share the loop
#include "lower/transform/privatise.h"

#include "ir/effects.h"
#include "ir/walk.h"
#include "lower/analysis/tree_size.h"
#include "lower/analysis/updates.h"
#include "lower/build/combination.h"
#include "lower/build/copy_statements.h"
#include "lower/build/statements.h"
#include "lower/build/workgroup_tree.h"
#include "lower/expand/dispatch.h"
#include "lower/transform/ordered_sums.h"
#include "lower/transform/update_ways.h"

#include <algorithm>
#include <bit>
#include <unordered_map>
#include <utility>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint32_t invocations = WorkgroupTree::invocations;  ///< in a workgroup
constexpr std::uint32_t copied_words = 4096 + 32;                  ///< of workgroup memory for copies: 16 KiB
constexpr std::uint32_t most_copies = 32;  ///< of one buffer: as many as most devices have banks

class Privatisation {
public:
    Privatisation(Context& context, UpdateWays ways, Updates& dependence)
        : cx(context), build(context.build), updates_(std::move(ways.updates)), dependence_(dependence),
          made_(std::move(ways.made)), axis_(ways.axis), has_runs_(ways.has_runs), copies_(count(UpdateWay::copies)) {}

    std::vector<PassUpdate> summary() const {
        std::vector<PassUpdate> result;
        for (const PrivateUpdate& update : updates_) {
            const bool is_copied = update.way == UpdateWay::copies;
            result.push_back({cx.p.stmts[update.stmt].slot, update.way, axis_, made_.elements[axis_],
                              is_copied ? words_of_copies() : 0, update.order, update.differs});
        }
        return result;
    }

    SeveralElements run(const std::vector<StmtId>& body) {
        note_inner(body);
        choose_first();
        for (PrivateUpdate& update : updates_) begin(update);
        if (count(UpdateWay::tree) + count(UpdateWay::column) != 0 && !is_of_blocks() && !dependence_.has_loop())
            made_.host_body = for_host(body);
        if (copies_ != 0) barrier();
        loop(body);
        if (copies_ != 0) barrier();
        std::optional<OrderedSums> sums;
        if (std::ranges::any_of(updates_, is_ordered)) sums.emplace(cx, made_);
        for (const std::vector<const PrivateUpdate*>& trees : trees_together())
            combine_in_workgroup(trees, sums ? &*sums : nullptr);
        for (const PrivateUpdate& update : updates_) end(update, sums ? &*sums : nullptr);
        return std::move(made_);
    }

private:
    bool is_of_blocks() const { return cx.pass.of_blocks; }

    std::uint32_t count(UpdateWay way) const {
        return static_cast<std::uint32_t>(
            std::ranges::count(updates_, way, [](const PrivateUpdate& update) { return update.way; }));
    }

    /// The workgroup's rows that trees combine.
    std::uint32_t rows() const { return axis_ == 0 && cx.pass.rank > 1 ? made_.elements[1] : 1; }

    Combination combination(const PrivateUpdate& update) const { return combination_of(cx, update); }

    static bool is_ordered(const PrivateUpdate& update) { return update.order.has_value(); }

    // Statements.

    Statements statements(const PrivateUpdate& update) { return {cx, cx.p.stmts[update.stmt].span}; }
    void barrier() { made_.body.push_back(Statements(cx, cx.kernel.span).barrier()); }

    ExprId less(ExprId a, ExprId b) { return build.binary(BinaryOp::less, a, b); }
    ExprId lane() { return build.builtin(Builtin::local_index, cx.p.types.uint); }

    std::string name_of(const PrivateUpdate& update) const {
        return cx.pass.bindings[cx.p.stmts[update.stmt].slot].name;
    }

    // The loop over elements.

    /// The address of the invocation's first element: pass.address, after which others of it are a workgroup's width
    /// apart along x; or, for runs, consecutive.
    void choose_first() {
        first_ = build.local(cx.pass.address);
        if (!has_runs_) return;
        const TypeId uint3 = cx.p.types.vector(cx.p.types.uint, 3);
        const ExprId place = build.component(build.builtin(Builtin::local_id, uint3), 0);
        const ExprId further = build.multiply(place, build.uint(made_.elements[0] - 1));
        first_ = Statements(cx, cx.kernel.span).let("first", address_at(further), made_.body);
    }

    /// The statements of one element. `hoisted` can run at any address of the range, and run for a batch of elements
    /// before the rest runs for the first of them, so that their loads overlap.
    struct Parts {
        std::vector<StmtId> hoisted, rest;
    };

    /// An element of the invocation, if it exists: the range may end before.
    struct Element {
        ExprId at, exists;
        std::optional<std::uint32_t> row;  ///< of the workgroup's rows; absent: there is one
    };

    void loop(const std::vector<StmtId>& body) {
        const Parts parts = divided(body);
        Statements make(cx, cx.kernel.span);
        remaining_ = left_along(axis_, make);
        if (rows() != 1) return rows_in_turn(parts, make);
        if (made_.elements[axis_] == 1) return take_one(parts);
        const std::uint32_t batch = batch_size(parts);
        in_turn(build.uint(made_.elements[axis_] / batch), [&](ExprId turn, std::vector<StmtId>& hoisted) {
            const ExprId first = build.multiply(turn, build.uint(batch));
            std::vector<StmtId> rest;
            for (std::uint32_t i = 0; i < batch; ++i) {
                const ExprId distance = build.multiply(build.add(first, build.uint(i)), build.uint(step()));
                const ExprId exists = build.binary(BinaryOp::less, distance, remaining_);
                rest.push_back(element(parts, {address_at(distance), exists, {}}, hoisted));
            }
            return rest;
        });
    }

    /// The elements of several rows: in each turn one of each row.
    void rows_in_turn(const Parts& parts, Statements make) {
        const ExprId rows_left = left_along(1, make), width = build.uint(step());
        const ExprId all = build.binary(BinaryOp::divide, build.add(remaining_, build.uint(step() - 1)), width);
        const ExprId most = build.uint(made_.elements[0]);
        const ExprId turns = build.intrinsic(Intrinsic::min, cx.p.types.uint, {all, most});
        in_turn(limited(make, "turns", turns, made_.elements[0]), [&](ExprId turn, std::vector<StmtId>& hoisted) {
            const ExprId distance = build.multiply(turn, width);
            const ExprId is_in_row = less(distance, remaining_);
            std::vector<StmtId> rest;
            for (std::uint32_t row = 0; row < rows(); ++row) {
                const ExprId exists = build.both(is_in_row, less(build.uint(row), rows_left));
                rest.push_back(element(parts, {address_at(distance, row), exists, row}, hoisted));
            }
            return rest;
        });
    }

    /// A loop over `count` turns. `body` adds to the statements of a turn, and returns those that come last.
    template <class Body> void in_turn(ExprId count, Body body) {
        Statements make(cx, cx.kernel.span);
        made_.body.push_back(make.loop("turn", count, [&](ExprId turn) {
            std::vector<StmtId> statements;
            const std::vector<StmtId> rest = body(turn, statements);
            statements.insert(statements.end(), rest.begin(), rest.end());
            return statements;
        }));
    }

    /// How many elements the range has along the axis, from the invocation's first one on.
    ExprId left_along(std::uint32_t axis, Statements make) {
        const auto along = [&](ExprId address) { return cx.pass.rank == 1 ? address : build.component(address, axis); };
        const ExprId left = build.binary(BinaryOp::subtract, along(cx.size), along(first_));
        return make.let("remaining", build.select(in_range_condition(cx, first_), left, build.uint(0)), made_.body);
    }

    /// From an element of the invocation to the next along the axis.
    std::uint32_t step() const { return axis_ == 0 && !has_runs_ ? made_.group[0] : 1; }

    /// Hoists `let`s of values that cannot change, conditions that load, and the values of unconditional updates.
    Parts divided(const std::vector<StmtId>& body) {
        Parts parts;
        for (StmtId id : body) {
            const StmtId made = rewritten(id);
            for (StmtId before : std::exchange(before_, {})) take(before, parts);
            if (has_runs_ && is_value_of_block(made)) made_.body.push_back(made);
            else take(made, parts);
        }
        return parts;
    }

    /// Whether the statement declares what is the same for all elements of the invocation's run, which lie in one
    /// block.
    bool is_value_of_block(StmtId id) const {
        const Stmt& stmt = cx.p.stmts[id];
        return stmt.op == StmtOp::let && dependence_.is_of_block(stmt.local);
    }

    void take(StmtId id, Parts& parts) {
        const Stmt stmt = cx.p.stmts[id];
        const bool may_be_hoisted = stmt.value && dependence_.is_fixed(stmt.value) && !uses(stmt.value, unhoisted_);
        if (may_be_hoisted && stmt.op == StmtOp::let && !cx.p.locals[stmt.local].is_mutable)
            return parts.hoisted.push_back(id);
        if (stmt.op == StmtOp::let) unhoisted_.insert(stmt.local);
        if (!may_be_hoisted || stmt.op != StmtOp::if_ || !dependence_.has_load(stmt.value))
            return parts.rest.push_back(id);
        const ExprId condition = Statements(cx, stmt.span).let("test", stmt.value, parts.hoisted);
        parts.rest.push_back(build.again(id, {stmt.target, condition, stmt.limit, stmt.body, stmt.otherwise}));
    }

    bool uses(ExprId id, const IdSet<Local>& locals) const {
        bool found = false;
        for_each_node(cx.p, id, [&](ExprId node) {
            const Expr& local = cx.p.exprs[node];
            found = found || (local.op == Op::local && locals.contains(local.local));
        });
        return found;
    }

    /// How many elements load before the first of them updates: more would take too many registers, and too much code.
    std::uint32_t batch_size(const Parts& parts) const {
        constexpr std::size_t most_loads = 16, most_nodes = 320;
        std::size_t loads = 0, nodes = 0;
        for_each_expression(cx.p, parts.hoisted, [&](ExprId id) { loads += is_load(cx.p.exprs[id].op); });
        for (const std::vector<StmtId>* statements : {&parts.hoisted, &parts.rest})
            for_each_expression(cx.p, *statements, [&](ExprId) { ++nodes; });
        if (loads == 0) return 1;
        std::uint32_t batch = 8;
        while (batch > 1 && (batch * loads > most_loads || batch * nodes > most_nodes)) batch /= 2;
        return batch;
    }

    /// Adds the hoisted statements of an element to `hoisted`; returns the rest. `exists` compares distances, since the
    /// address of an element that does not exist may exceed 32 bits.
    StmtId element(const Parts& parts, const Element& of, std::vector<StmtId>& hoisted) {
        const auto name = [&](std::string_view text, ExprId value) {
            return Statements(cx, cx.kernel.span).let(text, value, hoisted);
        };
        const ExprId exists = name("exists", of.exists);
        // Where the element does not exist, the hoisted statements run for the first element of the range.
        StatementCopy copy(cx, name("at", build.select(exists, of.at, build.zero(build.type(of.at)))));
        for (const PrivateUpdate& update : updates_)
            if (of.row && update.sum) copy.replace(update.sum, build.local(update.row_sums[*of.row]));
        for (StmtId id : parts.hoisted) hoisted.push_back(copy.of(id));
        Stmt inside = statement(StmtOp::if_, cx.kernel.span);
        inside.value = exists;
        for (StmtId id : parts.rest) inside.body.push_back(copy.of(id));
        return cx.add(std::move(inside));
    }

    /// The statements of an invocation's only element.
    void take_one(const Parts& parts) {
        std::vector<StmtId> before;
        const StmtId rest = element(parts, {first_, less(build.uint(0), remaining_), {}}, before);
        made_.body.insert(made_.body.end(), before.begin(), before.end());
        made_.body.push_back(rest);
    }

    /// The address `distance` elements along the axis from the invocation's first one, in one of the workgroup's rows.
    ExprId address_at(ExprId distance, std::uint32_t row = 0) {
        if (cx.pass.rank == 1) return build.add(first_, distance);
        Operands parts;
        for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) parts.push_back(build.component(first_, axis));
        parts[axis_] = build.add(parts[axis_], distance);
        if (row != 0) parts[1] = build.add(parts[1], build.uint(row));
        return build.construct(build.type(first_), std::move(parts));
    }

    /// The statements with updates of locals and of copies in place of those of memory.
    std::vector<StmtId> rewritten(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        for (StmtId id : body) result.push_back(rewritten(id));
        return result;
    }

    StmtId rewritten(StmtId id) {
        const auto update = std::ranges::find(updates_, id, &PrivateUpdate::stmt);
        if (update != updates_.end()) return replacement(*update);
        const Stmt& stmt = cx.p.stmts[id];
        if (stmt.body.empty() && stmt.otherwise.empty()) return id;
        Builder::Parts parts{stmt.target, stmt.value, stmt.limit, rewritten(stmt.body), {}};
        parts.otherwise = rewritten(cx.p.stmts[id].otherwise);
        return build.again(id, std::move(parts));
    }

    /// The value of an update, as a `let` in before_ if the element's address alone decides whether it is made, and if
    /// it can be computed outside of the ifs around the update.
    ExprId named_value(const PrivateUpdate& update, ExprId value) {
        const auto is_of_address = [&](const Condition& of) { return dependence_.is_same_along(axis_, of.value); };
        if (dependence_.has_loop() || is_trivial(cx, value)) return value;
        if (!std::ranges::all_of(update.conditions, is_of_address)) return value;
        const ExprId outside = outside_of_ifs(value);
        return outside ? statements(update).let(name_of(update) + "_value", outside, before_) : value;
    }

    /// The value without locals that ifs declare; absent if that is not possible.
    ExprId outside_of_ifs(ExprId value) {
        constexpr std::uint32_t most_nodes = 256;
        if (uses(value, inner_)) value = StatementCopy(cx, build.local(cx.pass.address)).with_definitions(value);
        const bool is_possible =
            !uses(value, inner_) && dependence_.is_fixed(value) && TreeSizes(cx).of(value) <= most_nodes;
        return is_possible ? value : ExprId{};
    }

    /// Notes the locals that the statements inside `body` declare.
    void note_inner(const std::vector<StmtId>& body) {
        for (StmtId id : body) {
            const Stmt& stmt = cx.p.stmts[id];
            for (const auto* inside : {&stmt.body, &stmt.otherwise})
                for_each_statement(cx.p, *inside, [&](const Stmt& inner) {
                    if (inner.op == StmtOp::let) inner_.insert(inner.local);
                });
        }
    }

    /// The statements for the host device, which makes updates by rows or columns (lower/host/row_updates.h). Loads for
    /// updates that the element's address alone decides are not under ifs, and neither are ordered sums: where one is
    /// not made, its index is that of no element, the largest one, for all elements of the row or column. So C++
    /// compilers vectorise them.
    std::vector<StmtId> for_host(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        for (StmtId id : body) {
            const StmtId made = outside_of_ifs(id);
            for (StmtId before : std::exchange(before_, {})) result.push_back(before);
            result.push_back(made);
        }
        return result;
    }

    StmtId outside_of_ifs(StmtId id) {
        const auto update = std::ranges::find(updates_, id, &PrivateUpdate::stmt);
        const bool is_private = update != updates_.end() && update->sum;
        if (is_private && update->order && make_always(*update))
            return cx.add(statement(StmtOp::block, cx.p.stmts[id].span));
        const Stmt& stmt = cx.p.stmts[id];
        Builder::Parts parts{stmt.target, stmt.value, stmt.limit, {}, {}};
        if (is_private) parts.value = named_value(*update, stmt.value);
        for (StmtId inside : cx.p.stmts[id].body) parts.body.push_back(outside_of_ifs(inside));
        for (StmtId inside : cx.p.stmts[id].otherwise) parts.otherwise.push_back(outside_of_ifs(inside));
        return build.again(id, std::move(parts));
    }

    /// Adds the update to before_ for every element; false if that is not possible.
    bool make_always(const PrivateUpdate& update) {
        const auto is_of_address = [&](const Condition& of) { return dependence_.is_same_along(axis_, of.value); };
        if (!std::ranges::all_of(update.conditions, is_of_address)) return false;
        Stmt stmt = cx.p.stmts[update.stmt];
        stmt.target = outside_of_ifs(stmt.target);
        stmt.value = outside_of_ifs(stmt.value);
        if (!stmt.target || !stmt.value) return false;
        ExprId condition;
        for (const Condition& of : update.conditions) {
            const ExprId value = outside_of_ifs(of.value);
            if (!value) return false;
            condition = build.both(condition, of.is_true ? value : build.negate(value));
        }
        if (condition) {
            stmt.value = statements(update).let(name_of(update) + "_value", stmt.value, before_);
            const TypeId index = build.type(stmt.target);
            const std::uint64_t largest = index == cx.p.types.uint ? 0xffffffffu : ~std::uint64_t{0};
            stmt.target = build.select(condition, stmt.target, build.integer(index, largest));
            stmt.value = build.select(condition, stmt.value, combination(update).identity());
        }
        before_.push_back(cx.add(std::move(stmt)));
        return true;
    }

    /// The statement that an element executes in place of its update.
    StmtId replacement(const PrivateUpdate& update) {
        const Stmt stmt = cx.p.stmts[update.stmt];
        const Combination combination = this->combination(update);
        if (update.way == UpdateWay::plain) return update.stmt;
        if (update.way == UpdateWay::run) return in_run(update);
        if (update.way == UpdateWay::copies) {
            const Copies& copies = copies_of_.at(update.stmt);
            const ExprId add =
                build.intrinsic(combination.intrinsic(), combination.type(),
                                {build.index(build.local(copies.array), build.add(copies.first, stmt.target)),
                                 combination.key(stmt.value)});
            return statements(update).where(less(stmt.target, copies.size), {statements(update).evaluate(add)},
                                            {update.stmt});
        }
        const ExprId sum = build.local(update.sum);
        const ExprId value = combination.key(named_value(update, stmt.value));
        return statements(update).assign(sum, combination.of(sum, value));
    }

    /// An element of another address ends the run, which updates memory.
    StmtId in_run(const PrivateUpdate& update) {
        const Stmt stmt = cx.p.stmts[update.stmt];
        Statements make = statements(update);
        const ExprId sum = build.local(update.sum), at = build.local(update.at);
        std::vector<StmtId> body;
        const ExprId next = make.let(name_of(update) + "_next", stmt.target, body);
        const StmtId ended =
            make.where(build.binary(BinaryOp::not_equal, next, at),
                       {end_run(update), make.assign(sum, combination(update).identity()), make.assign(at, next)});
        body.push_back(ended);
        body.push_back(make.assign(sum, combination(update).of(sum, combination(update).key(stmt.value))));
        Stmt block = statement(StmtOp::block, stmt.span);
        block.body = std::move(body);
        return cx.add(std::move(block));
    }

    StmtId end_run(const PrivateUpdate& update) {
        const ExprId sum = build.local(update.sum);
        Stmt stmt = cx.p.stmts[update.stmt];
        stmt.target = build.local(update.at);
        stmt.value = combination(update).value(sum);
        return statements(update).where(combination(update).changes(sum), {cx.add(std::move(stmt))});
    }

    void begin(PrivateUpdate& update) {
        if (update.way == UpdateWay::copies) return begin_copies(update);
        if (update.way == UpdateWay::plain) return;
        if (update.way == UpdateWay::run) {
            const ExprId zero = build.zero(build.type(cx.p.stmts[update.stmt].target));
            update.at = statements(update).variable(name_of(update) + "_at", zero, made_.body);
        }
        const ExprId identity = combination(update).identity();
        update.sum = statements(update).variable(name_of(update) + "_sum", identity, made_.body);
        if (update.way != UpdateWay::tree) return;
        update.row_sums.push_back(update.sum);
        for (std::uint32_t row = 1; row < rows(); ++row)
            update.row_sums.push_back(statements(update).variable(name_of(update) + "_sum", identity, made_.body));
    }

    void end(const PrivateUpdate& update, OrderedSums* sums) {
        if (update.way == UpdateWay::copies) return end_copies(update);
        if (update.way == UpdateWay::run) return made_.body.push_back(end_run(update));
        if (update.way != UpdateWay::column) return;
        const ExprId sum = build.local(update.sum);
        if (update.order) add(sums->meet(*update.order, sum, cx.p.stmts[update.stmt].span));
        update_memory(update, sum, build.local(cx.pass.address), {});
    }

    void add(const std::vector<StmtId>& statements) {
        made_.body.insert(made_.body.end(), statements.begin(), statements.end());
    }

    /// Updates by trees that are alike, so that one tree combines all of them.
    std::vector<std::vector<const PrivateUpdate*>> trees_together() const {
        constexpr std::uint32_t most_rows = WorkgroupTree::branches;
        const auto are_alike = [&](const PrivateUpdate& one, const PrivateUpdate& other) {
            return cx.p.stmts[one.stmt].combine == cx.p.stmts[other.stmt].combine && one.order == other.order &&
                   combination(one).type() == combination(other).type();
        };
        std::vector<std::vector<const PrivateUpdate*>> result;
        for (const PrivateUpdate& update : updates_) {
            if (update.way != UpdateWay::tree) continue;
            const auto group = std::ranges::find_if(result, [&](const auto& trees) {
                return are_alike(*trees.front(), update) && (trees.size() + 1) * rows() <= most_rows;
            });
            if (group == result.end()) result.push_back({&update});
            else group->push_back(&update);
        }
        return result;
    }

    void combine_in_workgroup(const std::vector<const PrivateUpdate*>& updates, OrderedSums* ordered) {
        const PrivateUpdate& first = *updates.front();
        const Span span = cx.p.stmts[first.stmt].span;
        const auto count = static_cast<std::uint32_t>(updates.size());
        WorkgroupTree tree(cx, combination(first), count == 1 ? name_of(first) + "_sums" : "sums", span,
                           count * rows());
        for (std::uint32_t i = 0; i < count; ++i)
            for (std::uint32_t row = 0; row < rows(); ++row)
                add({statements(first).assign(tree.own(build.uint(i * rows() + row)),
                                              build.local(updates[i]->row_sums[row]))});
        add(tree.combine(build.uint(tree.most_levels)));
        ExprId address = build.local(cx.pass.address);
        if (rows() != 1) address = statements(first).let("row", first_of_row(cx, lane()), made_.body);
        if (first.order) add(ordered->meet(*first.order, count, span, tree, address));
        // The invocation's row; no key beyond the last.
        const ExprId row = build.intrinsic(Intrinsic::min, cx.p.types.uint, {lane(), build.uint(rows() - 1)});
        for (std::uint32_t i = 0; i < count; ++i) {
            const ExprId key = rows() == 1 ? build.uint(i) : build.add(build.uint(i * rows()), row);
            update_memory(*updates[i], tree.first(key), address, less(lane(), build.uint(rows())));
        }
    }

    /// Updates memory by what elements have combined, if there is anything and `condition` holds; `address`: of one of
    /// them.
    void update_memory(const PrivateUpdate& update, ExprId key, ExprId address, ExprId condition) {
        const Combination combination = this->combination(update);
        StatementCopy copy(cx, address);
        condition = build.both(build.both(condition, in_range_condition(cx, address)), combination.changes(key));
        Stmt stmt = cx.p.stmts[update.stmt];
        stmt.target = copy.with_definitions(stmt.target);
        stmt.value = combination.value(key);
        made_.body.push_back(statements(update).where(condition, {cx.add(std::move(stmt))}));
    }

    // Copies in workgroup memory.

    struct Copies {
        LocalId array;
        ExprId size;   ///< the number of elements in a copy, the first ones of the buffer; 0: there are no copies
        ExprId count;  ///< of copies
        ExprId step;  ///< from an element in one copy to the same in the next: odd, so that they are in different banks
        ExprId first;  ///< the first element of this invocation's copy
    };

    std::uint32_t words_of_copies() const { return copied_words / std::bit_ceil(copies_); }

    /// A limit of the index, the same for all invocations, if the index is computed by a remainder or a mask; else
    /// absent. It may be wrong: which elements are copied decides how fast the pass is, not what it computes.
    ExprId limit_of(ExprId index) {
        const Expr node = cx.p.exprs[index];
        const ExprId* definition = node.op == Op::local ? cx.definitions.find(node.local) : nullptr;
        if (definition != nullptr) return limit_of(*definition);
        if (node.op != Op::binary || node.type != cx.p.types.uint) return {};
        const auto is_known = [&](std::size_t i) { return is_uniform(cx, node.operands[i]); };
        const std::size_t known = is_known(1) ? 1 : 0;
        if (node.binary == BinaryOp::remainder && known == 1) return node.operands[1];
        if (!is_known(known)) return {};
        if (node.binary == BinaryOp::bit_and) return build.add(node.operands[known], build.uint(1));
        if (node.binary != BinaryOp::add) return {};
        const ExprId rest = limit_of(node.operands[1 - known]);
        return rest ? build.add(node.operands[known], rest) : ExprId{};
    }

    /// The number of elements of the buffer.
    ExprId size_of_memory(const PrivateUpdate& update) {
        const PassBinding& binding = cx.pass.bindings[cx.p.stmts[update.stmt].slot];
        Expr extent;
        extent.op = Op::memory_extent;
        extent.type = cx.p.types.uint;
        extent.place = binding.place;
        extent.slot = binding.memory;
        return cx.p.exprs.add(std::move(extent));
    }

    void begin_copies(const PrivateUpdate& update) {
        const std::string name = name_of(update);
        const std::uint32_t words = words_of_copies();
        const ExprId zero = build.uint(0), one = build.uint(1);
        ExprId size = size_of_memory(update);
        if (const ExprId limit = limit_of(cx.p.stmts[update.stmt].target))
            size = build.intrinsic(Intrinsic::min, cx.p.types.uint, {size, limit});
        Copies copies;
        copies.array = statements(update).workgroup_array(name + "_copies", combination(update).type(), words);
        const ExprId copied = build.select(less(size, build.uint(words)), size, zero);
        cx.name(copied, name + "_copied");
        const ExprId is_possible = build.builtin(Builtin::adds_floats, cx.p.types.bool_);
        const ExprId all_or_none =
            combination(update).is_of_floats() ? build.select(is_possible, copied, zero) : copied;
        // A variable, so that what is computed of it does not become a parameter.
        copies.size = build.local(statements(update).variable(name + "_copied", all_or_none, made_.body));
        copies.step = build.binary(BinaryOp::bit_or, copies.size, one);
        const TypeId of_bits = cx.p.types.int_;
        const ExprId fitting = build.binary(BinaryOp::divide, build.uint(words), copies.step);
        const ExprId bits = build.intrinsic(Intrinsic::min, of_bits,
                                            {build.intrinsic(Intrinsic::findMSB, of_bits, {fitting}),
                                             build.integer(of_bits, std::countr_zero(most_copies))});
        const ExprId count = build.binary(BinaryOp::shift_left, one, build.convert(cx.p.types.uint, bits));
        copies.count = limited(statements(update), name + "_copy_count", count, most_copies);
        const ExprId last = build.binary(BinaryOp::subtract, copies.count, one);
        const ExprId mine = build.multiply(build.binary(BinaryOp::bit_and, lane(), last), copies.step);
        copies.first = statements(update).let(name + "_copy", mine, made_.body);
        const ExprId all = build.multiply(copies.count, copies.step);
        for_each_word(update, all, [&](ExprId at) -> std::vector<StmtId> {
            return {
                statements(update).assign(build.index(build.local(copies.array), at), combination(update).identity())};
        });
        copies_of_.emplace(update.stmt, copies);
    }

    void end_copies(const PrivateUpdate& update) {
        const Copies& copies = copies_of_.at(update.stmt);
        for_each_word(update, copies.size, [&](ExprId at) { return sum_of_copies(update, copies, at); });
    }

    /// A variable whose limit is known: else it becomes a parameter, and the rounds of loops up to it have to be
    /// counted.
    ExprId limited(Statements make, std::string_view name, ExprId value, std::uint32_t most) {
        const LocalId local = make.variable(name, value, made_.body);
        build.limits[local] = most;
        return build.local(local);
    }

    /// The workgroup's invocations execute `body` for the numbers up to `count`.
    template <class Body> void for_each_word(const PrivateUpdate& update, ExprId count, Body body) {
        const std::uint32_t most = (words_of_copies() + invocations - 1) / invocations;
        const ExprId last = build.add(count, build.uint(invocations - 1));
        const ExprId turns =
            limited(statements(update), "turns", build.binary(BinaryOp::divide, last, build.uint(invocations)), most);
        made_.body.push_back(statements(update).loop("turn", turns, [&](ExprId turn) -> std::vector<StmtId> {
            const ExprId at = build.add(build.multiply(turn, build.uint(invocations)), lane());
            return {statements(update).where(less(at, count), body(at))};
        }));
    }

    std::vector<StmtId> sum_of_copies(const PrivateUpdate& update, const Copies& copies, ExprId at) {
        const Combination combination = this->combination(update);
        Statements make = statements(update);
        std::vector<StmtId> result;
        const ExprId sum = build.local(make.variable("sum", combination.identity(), result));
        result.push_back(make.loop("copy", copies.count, [&](ExprId copy) -> std::vector<StmtId> {
            const ExprId place = build.add(build.multiply(copy, copies.step), at);
            const ExprId both = combination.of(sum, build.index(build.local(copies.array), place));
            return {make.assign(sum, both)};
        }));
        Stmt stmt = cx.p.stmts[update.stmt];
        stmt.target = at;
        stmt.value = combination.value(sum);
        const StmtId memory = cx.add(std::move(stmt));
        result.push_back(make.where(combination.changes(sum), {memory}));
        return result;
    }

    Context& cx;
    Builder& build;
    std::vector<PrivateUpdate> updates_;
    Updates& dependence_;
    SeveralElements made_;
    std::uint32_t axis_;
    bool has_runs_;
    ExprId first_;  ///< the address of the invocation's first element
    std::uint32_t copies_;
    std::unordered_map<StmtId, Copies> copies_of_;
    std::vector<StmtId> before_;  ///< `let`s that go before the statement of the body that is being rewritten
    IdSet<Local> inner_;          ///< locals that are declared inside ifs
    IdSet<Local> unhoisted_;      ///< locals that statements which are not hoisted declare
    ExprId remaining_;            ///< how many elements the range has along the axis, from the invocation's first on
};

}  // namespace

std::optional<SeveralElements> privatised(Context& cx, const std::vector<StmtId>& body) {
    if (cx.kernel.grouped() || cx.kernel.raster || cx.kernel.items != 1 || cx.pass.rank > 3) return {};
    // Workgroups that wait for one another must not wait for elements that an invocation takes later.
    const auto is_shared = [](const PassBinding& binding) { return binding.coherent && !binding.is_workspace; };
    if (std::ranges::any_of(cx.pass.bindings, is_shared)) return {};
    Updates dependence(cx);
    std::optional<UpdateWays> ways = ways_of_updates(cx, dependence.of(body), dependence);
    if (!ways) return {};
    Privatisation privatisation(cx, std::move(*ways), dependence);
    cx.pass.updates = privatisation.summary();
    return privatisation.run(body);
}

}  // namespace gliftc::lower
