#include "lower/transform/update_ways.h"

#include "ir/walk.h"
#include "lower/build/workgroup_tree.h"
#include "lower/expand/blocks.h"
#include "lower/transform/ordered_sums.h"

#include <algorithm>
#include <bit>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint32_t invocations = WorkgroupTree::invocations;  ///< in a workgroup
constexpr std::uint32_t elements_of_tree = 16;                     ///< that an invocation combines
constexpr std::uint32_t elements_of_column = 64;
constexpr std::uint32_t elements_of_copies = 128, elements_of_float_copies = 64;
constexpr std::uint32_t blocks_of_invocation = 16, blocks_with_copies = 32;

class Choice {
public:
    Choice(Context& context, const std::vector<Update>& updates, const Updates& dependence)
        : cx(context), build(context.build), dependence_(dependence) {
        for (const Update& update : updates) updates_.push_back({update});
    }

    std::optional<UpdateWays> run() {
        choose_combined();
        for (PrivateUpdate& update : updates_) {
            if (is_combined(update)) update.way = is_same_in_workgroup(update) ? UpdateWay::tree : UpdateWay::column;
            else if (may_be_run(update)) update.way = UpdateWay::run;
            else if (update.may_collide && may_be_copied(update)) update.way = UpdateWay::copies;
        }
        if (!is_chosen_) choose_other();
        if (!is_chosen_) return std::nullopt;
        choose_rows();
        choose_group();
        choose_orders();
        return UpdateWays{std::move(updates_), axis_, has_runs_, std::move(made_)};
    }

private:
    void take(std::uint32_t axis, std::uint32_t elements) {
        is_chosen_ = true;
        axis_ = axis;
        made_.elements[axis] = elements;
    }

    bool is_of_blocks() const { return cx.pass.of_blocks; }

    std::uint32_t count(UpdateWay way) const {
        return static_cast<std::uint32_t>(
            std::ranges::count(updates_, way, [](const PrivateUpdate& update) { return update.way; }));
    }

    Combination combination(const PrivateUpdate& update) const { return combination_of(cx, update); }

    bool is_same_along(const PrivateUpdate& update, std::uint32_t axis) const {
        return (update.same_along >> axis & 1) != 0;
    }

    /// Chooses an axis along which the address of some update is the same. In kernels over blocks it is y, which
    /// counts blocks. A kernel with loops takes one element an invocation.
    void choose_combined() {
        for (std::uint32_t axis = is_of_blocks() ? 1 : 0; axis < cx.pass.rank && !is_chosen_; ++axis) {
            const auto gains = [&](const PrivateUpdate& update) {
                return is_same_along(update, axis) && is_known(update) &&
                       (!dependence_.has_loop() || is_same_along(update, 0));
            };
            if (std::ranges::any_of(updates_, gains)) take(axis, elements_along(axis));
        }
    }

    std::uint32_t elements_along(std::uint32_t axis) const {
        if (dependence_.has_loop()) return 1;
        if (is_of_blocks()) return blocks_of_invocation;
        return axis == 0 ? elements_of_tree : elements_of_column;
    }

    bool is_combined(const PrivateUpdate& update) const {
        return is_chosen_ && is_same_along(update, axis_) && is_known(update) &&
               (!dependence_.has_loop() || is_same_in_workgroup(update));
    }

    /// Of a combined update: whether all invocations of a workgroup have its address.
    bool is_same_in_workgroup(const PrivateUpdate& update) const {
        return axis_ == 0 || (is_of_blocks() && is_same_along(update, 0));
    }

    bool may_be_run(const PrivateUpdate& update) const {
        return update.run > 1 && !is_chosen_ && !dependence_.has_loop() && is_known(update) &&
               cx.p.types.is_integer(build.type(cx.p.stmts[update.stmt].target));
    }

    /// Where no update is combined along an axis: runs, else copies.
    void choose_other() {
        std::uint32_t run = 1;
        for (const PrivateUpdate& update : updates_)
            if (update.way == UpdateWay::run) run = std::max(run, update.run);
        has_runs_ = run != 1;
        if (has_runs_) take(0, run);
        else if (count(UpdateWay::copies) != 0)
            take(cx.pass.rank == 1 ? 0 : 1, dependence_.has_loop() ? 1 : elements_with_copies());
    }

    /// Trees along x take several rows, so that short rows, which volumes have, occupy the workgroup, and so that loads
    /// overlap. More than `most_loads` would take too many registers, more than `most_trees`, each of 1 KiB, too much
    /// workgroup memory.
    void choose_rows() {
        constexpr std::uint32_t most_trees = 8, most_loads = 16;
        const std::uint32_t trees = count(UpdateWay::tree);
        if (trees == 0 || axis_ != 0 || cx.pass.rank == 1 || dependence_.has_loop()) return;
        std::uint32_t rows = cx.pass.rank == 2 ? 4 : most_trees;
        while (rows > 1 && (rows * dependence_.loads() > most_loads || rows * trees > most_trees)) rows /= 2;
        made_.elements[1] = rows;
    }

    void choose_group() {
        made_.group = cx.pass.group;
        const std::uint32_t width = is_of_blocks() ? width_over_blocks() : invocations;
        if (count(UpdateWay::tree) != 0 || is_of_blocks()) made_.group = {width, invocations / width, 1};
    }

    /// The power of two from which on the workgroup has room for the elements of a block.
    std::uint32_t width_over_blocks() const {
        constexpr std::uint32_t unknown = 64;
        const std::optional<std::uint64_t> volume = block_volume(cx);
        if (!volume) return unknown;
        const std::uint64_t taken = (*volume + row_length() - 1) / row_length();
        return static_cast<std::uint32_t>(std::bit_ceil(std::clamp<std::uint64_t>(taken, 1, invocations)));
    }

    /// More workgroups hide that devices add floats in workgroup memory slowly, and that the elements of a block are
    /// found through memory.
    std::uint32_t elements_with_copies() const {
        if (is_of_blocks()) return blocks_with_copies;
        const auto is_slow = [&](const PrivateUpdate& update) {
            return update.way == UpdateWay::copies && combination(update).is_sum_of_floats();
        };
        return std::ranges::any_of(updates_, is_slow) ? elements_of_float_copies : elements_of_copies;
    }

    /// How many consecutive elements along x an invocation takes.
    std::uint32_t row_length() const { return has_runs_ ? made_.elements[0] : 1; }

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
            return is_combined && !is_of_blocks() && !dependence_.has_loop() &&
                   combination(update).is_sum_of_floats() &&
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

    /// Whether it sets bits, such as those of pages to come: most elements set none, so that to combine them costs more
    /// than it saves.
    bool sets_bits(const PrivateUpdate& update) const {
        const Combine op = cx.p.stmts[update.stmt].combine;
        return op == Combine::bit_and || op == Combine::bit_or || op == Combine::bit_xor;
    }

    bool is_known(const PrivateUpdate& update) const {
        return combination(update).is_known() && !(is_of_blocks() && sets_bits(update));
    }

    bool may_be_copied(const PrivateUpdate& update) const {
        const Stmt& stmt = cx.p.stmts[update.stmt];
        const bool is_buffer = cx.pass.bindings[stmt.slot].shape == MemoryShape::buffer;
        const bool is_worth_it = !update.is_in_loop && !(dependence_.has_loop() && sets_bits(update));
        return is_buffer && is_worth_it && build.type(stmt.target) == cx.p.types.uint && is_known(update);
    }

    Context& cx;
    Builder& build;
    std::vector<PrivateUpdate> updates_;
    const Updates& dependence_;
    SeveralElements made_;
    std::uint32_t axis_ = 0;
    bool is_chosen_ = false;
    bool has_runs_ = false;
};

}  // namespace

Combination combination_of(Context& cx, const Update& update) {
    const Stmt& stmt = cx.p.stmts[update.stmt];
    return {cx.build, cx.pass.bindings[stmt.slot], stmt.combine};
}

std::optional<UpdateWays> ways_of_updates(Context& cx, const std::vector<Update>& updates, const Updates& dependence) {
    return Choice(cx, updates, dependence).run();
}

}  // namespace gliftc::lower
