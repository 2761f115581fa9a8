// long: one transformation; its steps share the loop and the choice
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

#include <algorithm>
#include <bit>
#include <unordered_map>
#include <utility>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint32_t invocations = WorkgroupTree::invocations;  ///< in a workgroup
constexpr std::uint32_t elements_of_tree = 16;                     ///< that an invocation combines
constexpr std::uint32_t elements_of_column = 64;
constexpr std::uint32_t elements_of_copies = 64;
constexpr std::uint32_t copied_words = 4096 + 32;  ///< of workgroup memory for copies: 16 KiB
constexpr std::uint32_t most_copies = 32;          ///< of one buffer: as many as most devices have banks

/// An update, what becomes of it, and the locals that this takes.
struct PrivateUpdate : Update {
    UpdateWay way = UpdateWay::plain;
    std::optional<SumOrder> order;
    LocalId sum;  ///< of tree and column: what the invocation has combined
};

class Privatisation {
public:
    Privatisation(Context& context, const std::vector<Update>& updates, Updates& dependence)
        : cx(context), build(context.build), dependence_(dependence) {
        for (const Update& update : updates) updates_.push_back({update});
    }

    /// Chooses the axis along which invocations take elements, and what becomes of each update. False: no gain.
    bool choose() {
        const auto combines = [&](const PrivateUpdate& update, std::uint32_t axis) {
            return (update.same_along >> axis & 1) != 0 && combination(update).is_known();
        };
        for (std::uint32_t axis = 0; axis < cx.pass.rank && !is_chosen_; ++axis) {
            const auto gains = [&](const PrivateUpdate& update) { return combines(update, axis); };
            if (std::ranges::any_of(updates_, gains)) take(axis, axis == 0 ? elements_of_tree : elements_of_column);
        }
        for (PrivateUpdate& update : updates_) {
            if (is_chosen_ && combines(update, axis_)) update.way = axis_ == 0 ? UpdateWay::tree : UpdateWay::column;
            else if (update.may_collide && may_be_copied(update)) update.way = UpdateWay::copies;
        }
        copies_ = static_cast<std::uint32_t>(
            std::ranges::count(updates_, UpdateWay::copies, [](const PrivateUpdate& update) { return update.way; }));
        if (!is_chosen_ && copies_ != 0) take(cx.pass.rank == 1 ? 0 : 1, elements_of_copies);
        choose_group();
        choose_orders();
        return is_chosen_;
    }

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
        for (PrivateUpdate& update : updates_) begin(update);
        if (std::ranges::any_of(updates_, [](const PrivateUpdate& of) { return bool(of.sum); }))
            made_.host_body = for_host(body);
        if (copies_ != 0) barrier();
        loop(body);
        if (copies_ != 0) barrier();
        std::optional<OrderedSums> sums;
        if (std::ranges::any_of(updates_, is_ordered)) sums.emplace(cx, made_);
        for (const PrivateUpdate& update : updates_) end(update, sums ? &*sums : nullptr);
        return std::move(made_);
    }

private:
    void take(std::uint32_t axis, std::uint32_t elements) {
        is_chosen_ = true;
        axis_ = axis;
        made_.elements[axis] = elements;
    }

    static bool is_ordered(const PrivateUpdate& update) { return update.order.has_value(); }

    void choose_group() {
        const auto is_tree = [](const PrivateUpdate& update) { return update.way == UpdateWay::tree; };
        if (std::ranges::any_of(updates_, is_tree)) made_.group = {invocations, 1, 1};
        else made_.group = cx.pass.group;
    }

    bool is_updated_by_function(std::uint32_t slot) const {
        return std::ranges::any_of(cx.instances, [&](const auto& instance) {
            bool found = false;
            for_each_statement(cx.p, cx.p.functions[instance.second].body, [&](const Stmt& stmt) {
                found = found || (stmt.op == StmtOp::atomic && stmt.slot == slot);
            });
            return found;
        });
    }

    /// Sums of floats get an order, if each is the only update of its buffer.
    void choose_orders() {
        const auto slot_of = [&](const PrivateUpdate& update) { return cx.p.stmts[update.stmt].slot; };
        const auto may_have_order = [&](const PrivateUpdate& update) {
            const bool is_combined = update.way == UpdateWay::tree || update.way == UpdateWay::column;
            return is_combined && combination(update).is_sum_of_floats() &&
                   cx.pass.bindings[slot_of(update)].shape == MemoryShape::buffer &&
                   std::ranges::count(updates_, slot_of(update), slot_of) == 1 &&
                   !is_updated_by_function(slot_of(update));
        };
        const auto sums = static_cast<std::size_t>(std::ranges::count_if(updates_, may_have_order));
        for (PrivateUpdate& update : updates_) {
            if (!may_have_order(update)) continue;
            update.order = order_of_sum(update.same_along, axis_, made_, sums);
        }
    }

    Combination combination(const PrivateUpdate& update) const {
        const Stmt& stmt = cx.p.stmts[update.stmt];
        return {build, cx.pass.bindings[stmt.slot], stmt.combine};
    }

    bool may_be_copied(const PrivateUpdate& update) const {
        const Stmt& stmt = cx.p.stmts[update.stmt];
        const bool is_buffer = cx.pass.bindings[stmt.slot].shape == MemoryShape::buffer;
        return is_buffer && build.type(stmt.target) == cx.p.types.uint && combination(update).is_known();
    }

    // Statements.

    Statements statements(const PrivateUpdate& update) { return {cx, cx.p.stmts[update.stmt].span}; }
    void barrier() { made_.body.push_back(Statements(cx, cx.kernel.span).barrier()); }

    ExprId less(ExprId a, ExprId b) { return build.binary(BinaryOp::less, a, b); }
    ExprId lane() { return build.builtin(Builtin::local_index, cx.p.types.uint); }

    std::string name_of(const PrivateUpdate& update) const {
        return cx.pass.bindings[cx.p.stmts[update.stmt].slot].name;
    }

    // The loop over elements.

    void loop(const std::vector<StmtId>& body) {
        const Parts parts = divided(body);
        const std::uint32_t batch = batch_size(parts);
        const ExprId left =
            build.binary(BinaryOp::subtract, component(cx.size), component(build.local(cx.pass.address)));
        remaining_ = Statements(cx, cx.kernel.span)
                         .let("remaining", build.select(in_range_condition(cx), left, build.uint(0)), made_.body);
        Stmt loop = statement(StmtOp::for_, cx.kernel.span);
        loop.local = cx.new_local("turn", cx.p.types.uint, cx.kernel.span);
        loop.value = build.uint(0);
        loop.limit = build.uint(made_.elements[axis_] / batch);
        const ExprId first = build.multiply(build.local(loop.local), build.uint(batch));
        std::vector<StmtId> statements, rest;
        for (std::uint32_t i = 0; i < batch; ++i)
            rest.push_back(element(parts, build.add(first, build.uint(i)), statements));
        statements.insert(statements.end(), rest.begin(), rest.end());
        loop.body = std::move(statements);
        made_.body.push_back(cx.add(std::move(loop)));
    }

    /// The statements of one element. `hoisted` can run at any address of the range, and run for a batch of elements
    /// before the rest runs for the first of them, so that their loads overlap.
    struct Parts {
        std::vector<StmtId> hoisted, rest;
    };

    /// Hoists `let`s of values that cannot change, conditions that load, and the values of unconditional updates.
    Parts divided(const std::vector<StmtId>& body) {
        Parts parts;
        for (StmtId id : body) {
            const StmtId made = rewritten(id);
            for (StmtId before : std::exchange(before_, {})) take(before, parts);
            take(made, parts);
        }
        return parts;
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

    /// Adds the hoisted statements of the invocation's element `number` to `hoisted`; returns the rest.
    StmtId element(const Parts& parts, ExprId number, std::vector<StmtId>& hoisted) {
        const std::uint32_t step = axis_ == 0 ? made_.group[0] : 1;
        const ExprId distance = build.multiply(number, build.uint(step)), at = address_at(distance);
        const auto name = [&](std::string_view text, ExprId value) {
            return Statements(cx, cx.kernel.span).let(text, value, hoisted);
        };
        // Compares distances, since the address of an element that does not exist may exceed 32 bits.
        const ExprId exists = name("exists", less(distance, remaining_));
        // Where the element does not exist, the hoisted statements run for the first element of the range.
        StatementCopy copy(cx, name("at", build.select(exists, at, build.zero(build.type(at)))));
        for (StmtId id : parts.hoisted) hoisted.push_back(copy.of(id));
        Stmt inside = statement(StmtOp::if_, cx.kernel.span);
        inside.value = exists;
        for (StmtId id : parts.rest) inside.body.push_back(copy.of(id));
        return cx.add(std::move(inside));
    }

    /// The component along the axis of the loop.
    ExprId component(ExprId address) { return cx.pass.rank == 1 ? address : build.component(address, axis_); }

    /// The address `distance` elements from the invocation's first one.
    ExprId address_at(ExprId distance) {
        const ExprId address = build.local(cx.pass.address);
        if (cx.pass.rank == 1) return build.add(address, distance);
        Operands parts;
        for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) parts.push_back(build.component(address, axis));
        parts[axis_] = build.add(parts[axis_], distance);
        return build.construct(build.type(address), std::move(parts));
    }

    /// The statements with updates of locals and of copies in place of those of memory.
    std::vector<StmtId> rewritten(const std::vector<StmtId>& body) {
        std::vector<StmtId> result;
        for (StmtId id : body) result.push_back(rewritten(id));
        return result;
    }

    StmtId rewritten(StmtId id) {
        const auto update = std::ranges::find(updates_, id, &PrivateUpdate::stmt);
        if (update != updates_.end()) return in_turn(*update);
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
        if (!std::ranges::all_of(update.conditions, is_of_address) || is_trivial(cx, value)) return value;
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
    StmtId in_turn(const PrivateUpdate& update) {
        const Stmt stmt = cx.p.stmts[update.stmt];
        const Combination combination = this->combination(update);
        if (update.way == UpdateWay::plain) return update.stmt;
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

    void begin(PrivateUpdate& update) {
        if (update.way == UpdateWay::copies) return begin_copies(update);
        if (update.way == UpdateWay::plain) return;
        update.sum = statements(update).variable(name_of(update) + "_sum", combination(update).identity(), made_.body);
    }

    void end(const PrivateUpdate& update, OrderedSums* sums) {
        if (update.way == UpdateWay::copies) return end_copies(update);
        if (update.way == UpdateWay::plain) return;
        const ExprId sum = build.local(update.sum);
        if (update.way == UpdateWay::tree) return combine_in_workgroup(update, sums);
        if (update.order) meet(update, *sums, sum, nullptr);
        update_memory(update, sum, {});
    }

    void meet(const PrivateUpdate& update, OrderedSums& sums, ExprId sum, WorkgroupTree* tree) {
        for (StmtId id : sums.meet(*update.order, sum, cx.p.stmts[update.stmt].span, tree)) made_.body.push_back(id);
    }

    void combine_in_workgroup(const PrivateUpdate& update, OrderedSums* ordered) {
        WorkgroupTree tree(cx, combination(update), name_of(update) + "_sums", cx.p.stmts[update.stmt].span);
        for (StmtId id : tree.combine(build.local(update.sum), build.uint(tree.most_levels))) made_.body.push_back(id);
        if (update.order) meet(update, *ordered, tree.first(), &tree);
        update_memory(update, tree.first(), build.binary(BinaryOp::equal, lane(), build.uint(0)));
    }

    /// Updates memory by what elements have combined, if there is anything and `condition` holds.
    void update_memory(const PrivateUpdate& update, ExprId key, ExprId condition) {
        const Combination combination = this->combination(update);
        StatementCopy copy(cx, build.local(cx.pass.address));
        condition = build.both(build.both(condition, in_range_condition(cx)), combination.changes(key));
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
        copies.count = limited(update, name + "_copy_count", count, most_copies, made_.body);
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
    ExprId limited(const PrivateUpdate& update, std::string_view name, ExprId value, std::uint32_t most,
                   std::vector<StmtId>& body) {
        const LocalId local = statements(update).variable(name, value, body);
        build.limits[local] = most;
        return build.local(local);
    }

    /// The workgroup's invocations execute `body` for the numbers up to `count`.
    template <class Body> void for_each_word(const PrivateUpdate& update, ExprId count, Body body) {
        const std::uint32_t most = (words_of_copies() + invocations - 1) / invocations;
        const ExprId last = build.add(count, build.uint(invocations - 1));
        const ExprId turns =
            limited(update, "turns", build.binary(BinaryOp::divide, last, build.uint(invocations)), most, made_.body);
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
    std::uint32_t axis_ = 0;
    bool is_chosen_ = false;
    std::uint32_t copies_ = 0;
    std::unordered_map<StmtId, Copies> copies_of_;
    std::vector<StmtId> before_;  ///< `let`s that go before the statement of the body that is being rewritten
    IdSet<Local> inner_;          ///< locals that are declared inside ifs
    IdSet<Local> unhoisted_;      ///< locals that statements which are not hoisted declare
    ExprId remaining_;            ///< how many elements the range has along the axis, from the invocation's first on
};

}  // namespace

std::optional<SeveralElements> privatised(Context& cx, const std::vector<StmtId>& body) {
    if (cx.kernel.grouped() || cx.kernel.space || cx.kernel.raster || cx.kernel.items != 1 || cx.pass.rank > 3)
        return {};
    // Workgroups that wait for one another must not wait for elements that an invocation takes later.
    const auto is_shared = [](const PassBinding& binding) { return binding.coherent && !binding.is_workspace; };
    if (std::ranges::any_of(cx.pass.bindings, is_shared)) return {};
    Updates dependence(cx);
    Privatisation privatisation(cx, dependence.of(body), dependence);
    if (!privatisation.choose()) return {};
    cx.pass.updates = privatisation.summary();
    return privatisation.run(body);
}

}  // namespace gliftc::lower
