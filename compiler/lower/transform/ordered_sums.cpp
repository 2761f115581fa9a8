#include "lower/transform/ordered_sums.h"

#include "lower/expand/dispatch.h"
#include "lower/expand/memory.h"

#include <algorithm>
#include <bit>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint32_t lanes_of_tree = WorkgroupTree::invocations;
constexpr std::size_t most_rounds = 16384;  ///< of the loops over parts: lavapipe ends an invocation's loops at 65,535

constexpr std::uint32_t parts_of_turn = 8;  ///< whose loads overlap

/// The binding of the memory in which parts meet, which is added if it is not there.
std::uint32_t workspace_of(Context& cx) {
    std::vector<PassBinding>& bindings = cx.pass.bindings;
    const auto found = std::ranges::find_if(bindings, &PassBinding::is_workspace);
    if (found != bindings.end()) return static_cast<std::uint32_t>(found - bindings.begin());
    PassBinding made;
    made.name = "partial_sums";
    made.element = cx.p.types.uint;
    made.access = Access::read_write;
    made.atomic = made.coherent = made.is_workspace = true;
    made.one_place = static_cast<std::uint32_t>(bindings.size());
    bindings.push_back(std::move(made));
    return bindings.back().one_place;
}

/// A number with several digits, the lowest first: adds digits, each below its limit.
struct Linear {
    Builder& build;
    ExprId number, count;  ///< absent: 0, 1

    void add(ExprId digit, ExprId limit) {
        number = number ? build.add(number, build.multiply(digit, count)) : digit;
        count = count ? build.multiply(count, limit) : limit;
    }
    ExprId value() { return number ? number : build.uint(0); }
    ExprId limit() { return count ? count : build.uint(1); }
};

}  // namespace

SumOrder order_of_sum(std::uint8_t same_along, std::uint32_t axis, const SeveralElements& made, std::size_t sums) {
    const bool has_rows = axis == 0 && (same_along >> 1 & 1) == 0;  // whose parts are added in turn
    const auto rounds =
        static_cast<std::uint32_t>(most_rounds / std::bit_ceil(sums) / (has_rows ? made.elements[1] : 1));
    return {same_along, axis, made.elements[axis] * (axis == 0 ? made.group[0] : 1),
            axis == 0 ? rounds * lanes_of_tree : rounds};
}

/// Where an invocation's part, and the others of its sum, lie in the memory.
struct OrderedSums::Numbers {
    ExprId parts;       ///< of the sum
    ExprId counter;     ///< the word that counts workgroups
    ExprId groups;      ///< how many share it
    ExprId own;         ///< the word of the invocation's part
    ExprId first;       ///< the word of the sum's first part
    ExprId step;        ///< from one part of the sum to the next; absent: 1
    ExprId start, end;  ///< of the words of all sums of the update
};

OrderedSums::OrderedSums(Context& context, const SeveralElements& made)
    : cx(context), build(context.build), made_(made), slot_(workspace_of(context)), used_(build.uint(0)) {}

ExprId OrderedSums::component(ExprId vector, std::uint32_t axis) {
    return cx.pass.rank == 1 ? vector : build.component(vector, axis);
}

/// The quotient, rounded up, of a value that is not 0.
ExprId OrderedSums::quotient_up(ExprId value, std::uint32_t divisor) {
    if (divisor == 1) return value;
    const ExprId before = build.binary(BinaryOp::subtract, value, build.uint(1));
    return build.add(quotient(before, divisor), build.uint(1));
}

/// Names the value, for parameters that hold it.
ExprId OrderedSums::named(ExprId value, std::string_view name, std::uint32_t axis) {
    cx.name(value, std::string(name) + "_" + "xyz"[axis]);
    return value;
}

/// The memory of a sum's update: for each sum two words, of which some are counters (the host device has indices
/// there), then the words of parts; those of a row one after the other, of columns in the order of the columns.
OrderedSums::Numbers OrderedSums::numbers(const SumOrder& order, ExprId start, ExprId address, Statements make,
                                          std::vector<StmtId>& body) {
    Linear sum{build, {}, {}}, part = sum, counter = sum, groups = sum;
    for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) {
        const ExprId at = component(address, axis);
        if ((order.axes >> axis & 1) == 0) {
            sum.add(at, size(axis));
            counter.add(quotient(at, elements_of_group(axis)), quotient_up(size(axis), elements_of_group(axis)));
            continue;
        }
        const std::uint32_t cut = axis == order.axis ? order.part : 1;
        part.add(quotient(at, cut), named(quotient_up(size(axis), cut), "part_count", axis));
        groups.add(build.uint(0), named(quotient_up(size(axis), elements_of_group(axis)), "group_count", axis));
    }
    cx.name(sum.limit(), "sum_count");
    cx.name(part.limit(), "part_count");
    cx.name(groups.limit(), "group_count");
    const ExprId first_part = build.add(start, build.multiply(build.uint(2), sum.limit()));
    Numbers result;
    result.start = start;
    result.end = build.add(first_part, build.multiply(sum.limit(), part.limit()));
    result.parts = part.limit();
    result.counter = make.let("counter", build.add(start, counter.value()), body);
    result.groups = groups.limit();
    const bool is_tree = order.axis == 0;
    result.first = make.let(
        "first_part", build.add(first_part, is_tree ? build.multiply(sum.value(), part.limit()) : sum.value()), body);
    if (!is_tree) result.step = sum.limit();
    result.own = build.add(result.first, is_tree ? part.value() : build.multiply(part.value(), result.step));
    return result;
}

ExprId OrderedSums::word(ExprId at) { return load_from(cx, slot_, at); }

ExprId OrderedSums::nothing() { return build.unary(UnaryOp::minus, build.zero(cx.p.types.float_)); }

ExprId OrderedSums::lane() { return build.builtin(Builtin::local_index, cx.p.types.uint); }

ExprId OrderedSums::is_first_lane() { return build.binary(BinaryOp::equal, lane(), build.uint(0)); }

StmtId OrderedSums::stored(const Numbers& of, ExprId sum, Statements make) {
    const ExprId bits = build.intrinsic(Intrinsic::floatBitsToUint, cx.p.types.uint, {sum});
    return make.store(slot_, index_of(cx, slot_, of.own), bits);
}

/// Counts the workgroup: 1 if it is the last one, else 0. The addition releases the stores: those of this invocation,
/// and those that a barrier orders before it.
ExprId OrderedSums::counted(const Numbers& of, Statements make, std::vector<StmtId>& body) {
    const Types& types = cx.p.types;
    const ExprId one_more = build.intrinsic(Intrinsic::atomicAdd, types.uint, {word(of.counter), build.uint(1)});
    const ExprId before = make.let("arrived", one_more, body);
    return build.convert(types.uint, build.binary(BinaryOp::equal, build.add(before, build.uint(1)), of.groups));
}

/// The invocations store their parts, and the workgroup is counted.
std::vector<StmtId> OrderedSums::stored_columns(const Numbers& of, ExprId sum, ExprId is_last, Statements make) {
    std::vector<StmtId> first;
    first.push_back(make.assign(is_last, counted(of, make, first)));
    return {make.where(in_range_condition(cx), {stored(of, sum, make)}), make.assign(sum, nothing()), make.barrier(),
            make.where(is_first_lane(), std::move(first)), make.barrier()};
}

/// Invocation i stores the parts of the workgroup's row i, and the workgroup is counted. A workgroup beyond the range
/// (line_address of dispatch.cpp) has no parts.
std::vector<StmtId> OrderedSums::stored_rows(const std::vector<Numbers>& of, WorkgroupTree& tree, ExprId row,
                                             ExprId is_last, Statements make) {
    const auto rows = static_cast<std::uint32_t>(tree.rows() / of.size());
    const ExprId in_range = in_range_condition(cx, row);
    std::vector<StmtId> stores, resets, first, counts;
    for (std::uint32_t i = 0; i < of.size(); ++i) {
        const ExprId own = tree.first(rows == 1 ? build.uint(i) : build.add(build.uint(i * rows), lane()));
        stores.push_back(stored(of[i], own, make));
        resets.push_back(make.assign(own, nothing()));
    }
    const ExprId found = build.local(make.variable("found", build.uint(0), first));
    if (rows == 1) counts = stores;
    counts.push_back(make.assign(found, counted(of.front(), make, counts)));
    first.push_back(make.where(in_range, std::move(counts)));
    first.push_back(make.assign(is_last, found));
    if (rows == 1) {
        first.insert(first.end(), resets.begin(), resets.end());
        return {make.where(is_first_lane(), std::move(first)), make.barrier()};
    }
    std::vector<StmtId> by_rows{make.where(in_range, std::move(stores))};
    by_rows.insert(by_rows.end(), resets.begin(), resets.end());
    const ExprId has_row = build.binary(BinaryOp::less, lane(), build.uint(rows));
    return {make.where(has_row, std::move(by_rows)), make.barrier(), make.where(is_first_lane(), std::move(first)),
            make.barrier()};
}

/// Adds parts of several sums, of which each has as many, to `shares`: in a tree every 256th, from the invocation's own
/// number on, else all. First several in a turn, whose loads overlap, then one. The turns of several are not for
/// devices that do not skip branches: each workgroup would execute them.
void OrderedSums::add_parts(const SumOrder& order, const std::vector<Numbers>& of, const std::vector<ExprId>& shares,
                            Statements make, std::vector<StmtId>& body) {
    const bool is_tree = order.axis == 0;
    const std::uint32_t stride = is_tree ? lanes_of_tree : 1, several = parts_of_turn * stride;
    const ExprId count = of.front().parts;
    // Variables, whose limits are known: else they become parameters, and the rounds would have to be counted.
    const auto limit = [&](std::string_view name, ExprId value, std::uint32_t most) {
        const LocalId local = make.variable(name, value, body);
        build.limits[local] = most;
        return build.local(local);
    };
    const auto add = [&](ExprId first, std::uint32_t parts) {
        std::vector<StmtId> statements, adds;
        for (std::size_t sum = 0; sum < of.size(); ++sum)
            for (std::uint32_t i = 0; i < parts; ++i) {
                const ExprId number = build.add(first, build.uint(i * stride));
                const ExprId at = build.add(of[sum].first, is_tree ? number : build.multiply(number, of[sum].step));
                const ExprId bits = make.let("part", word(at), statements);
                const ExprId part = build.intrinsic(Intrinsic::uintBitsToFloat, cx.p.types.float_, {bits});
                adds.push_back(make.assign(shares[sum], build.add(shares[sum], part)));
            }
        statements.insert(statements.end(), adds.begin(), adds.end());
        return statements;
    };
    const auto number_at = [&](ExprId start) { return is_tree ? build.add(start, lane()) : start; };
    const ExprId overlaps = build.builtin(Builtin::skips_branches, cx.p.types.bool_);
    const ExprId turns =
        limit("turns", build.select(overlaps, quotient(count, several), build.uint(0)), order.most_parts / several);
    const StmtId loop = make.loop("turn", turns, [&](ExprId turn) {
        return add(number_at(build.multiply(turn, build.uint(several))), parts_of_turn);
    });
    body.push_back(make.where(overlaps, {loop}));
    const ExprId done = make.let("done", build.multiply(turns, build.uint(several)), body);
    const ExprId left = build.binary(BinaryOp::subtract, count, done);
    const ExprId rest = limit("rest", is_tree ? quotient(build.add(left, build.uint(stride - 1)), stride) : left,
                              order.most_parts / stride);
    body.push_back(make.loop("turn", rest, [&](ExprId turn) -> std::vector<StmtId> {
        const ExprId number = number_at(build.add(done, build.multiply(turn, build.uint(stride))));
        if (!is_tree) return add(number, 1);
        return {make.where(build.binary(BinaryOp::less, number, count), add(number, 1))};
    }));
}

/// Of the invocations that have parts of one column's sum, one adds them.
ExprId OrderedSums::adds_column(const SumOrder& order) {
    ExprId adds = in_range_condition(cx);
    for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) {
        if ((order.axes >> axis & 1) == 0 || made_.group[axis] == 1) continue;
        const TypeId uint3 = cx.p.types.vector(cx.p.types.uint, 3);
        const ExprId place = build.component(build.builtin(Builtin::local_id, uint3), axis);
        adds = build.both(adds, build.binary(BinaryOp::equal, place, build.uint(0)));
    }
    return adds;
}

ExprId OrderedSums::has_several_parts(const SumOrder& order, const Numbers& of) {
    const ExprId several = build.binary(BinaryOp::less, build.uint(1), of.parts);
    return build.both(several, build.binary(BinaryOp::less_equal, of.parts, build.uint(order.most_parts)));
}

/// The word that says whether the workgroup is the last one.
ExprId OrderedSums::last_flag(Statements make) {
    return build.index(build.local(make.workgroup_array("is_last", cx.p.types.uint, 1)), build.uint(0));
}

/// The last workgroup begins. The loads of parts may overlap: only the first load is an acquire.
void OrderedSums::acquire(const Numbers& of, Statements make, std::vector<StmtId>& body) {
    make.let("seen", build.intrinsic(Intrinsic::atomicLoad, cx.p.types.uint, {word(of.counter)}), body);
}

std::vector<StmtId> OrderedSums::meet(const SumOrder& order, ExprId sum, Span span) {
    Statements make(cx, span);
    std::vector<StmtId> body, last, adds;
    const Numbers of = numbers(order, used_, build.local(cx.pass.address), make, body);
    const ExprId is_last = last_flag(make);
    for (StmtId id : stored_columns(of, sum, is_last, make)) body.push_back(id);
    acquire(of, make, last);
    const ExprId share = build.local(make.variable("share", nothing(), last));
    add_parts(order, {of}, {share}, make, adds);
    adds.push_back(make.assign(sum, share));
    last.push_back(make.where(adds_column(order), std::move(adds)));
    body.push_back(make.where(build.binary(BinaryOp::not_equal, is_last, build.uint(0)), std::move(last)));
    used_ = of.end;
    return {make.where(has_several_parts(order, of), std::move(body))};
}

std::vector<StmtId> OrderedSums::meet(const SumOrder& order, std::uint32_t sums, Span span, WorkgroupTree& tree,
                                      ExprId row) {
    Statements make(cx, span);
    std::vector<StmtId> body, last;
    std::vector<Numbers> of;
    for (std::uint32_t i = 0; i < sums; ++i) {
        of.push_back(numbers(order, used_, row, make, body));
        used_ = of.back().end;
    }
    const ExprId is_last = last_flag(make);
    for (StmtId id : stored_rows(of, tree, row, is_last, make)) body.push_back(id);
    acquire(of.front(), make, last);
    add_rows(order, of, tree, is_last, make, last);
    // Lavapipe runs the body of an if whose condition does not hold, too: with 0 levels in the other workgroups.
    const LocalId levels = make.variable("levels", build.multiply(is_last, build.uint(tree.most_levels)), last);
    build.limits[levels] = tree.most_levels;
    for (StmtId id : tree.combine(build.local(levels))) last.push_back(id);
    body.push_back(make.where(build.binary(BinaryOp::not_equal, is_last, build.uint(0)), std::move(last)));
    return {make.where(has_several_parts(order, of.front()), std::move(body))};
}

/// The invocations add the parts of the workgroup's rows; if all rows have one sum, as parts of the first row.
void OrderedSums::add_rows(const SumOrder& order, const std::vector<Numbers>& of, WorkgroupTree& tree, ExprId is_last,
                           Statements make, std::vector<StmtId>& body) {
    const auto rows = static_cast<std::uint32_t>(tree.rows() / of.size());
    const auto own = [&](std::size_t sum, ExprId row) {
        return tree.own(build.add(build.uint(static_cast<std::uint32_t>(sum) * rows), row));
    };
    const auto add = [&](ExprId row, const std::vector<Numbers>& numbers, std::vector<StmtId>& statements) {
        std::vector<ExprId> shares;
        for (std::size_t sum = 0; sum < of.size(); ++sum)
            shares.push_back(build.local(make.variable("share", nothing(), statements)));
        add_parts(order, numbers, shares, make, statements);
        for (std::size_t sum = 0; sum < of.size(); ++sum) statements.push_back(make.assign(own(sum, row), shares[sum]));
    };
    const auto numbers_of = [&](ExprId row, std::vector<StmtId>& statements) {
        std::vector<Numbers> result;
        for (const Numbers& sum : of)
            result.push_back(numbers(order, sum.start, first_of_row(cx, row), make, statements));
        return result;
    };
    const bool is_one_sum = (order.axes >> 1 & 1) != 0;
    if (rows == 1) return add(build.uint(0), of, body);
    if (is_one_sum) {
        add(build.uint(0), numbers_of(build.uint(0), body), body);
        for (std::size_t sum = 0; sum < of.size(); ++sum)
            for (std::uint32_t row = 1; row < rows; ++row)
                body.push_back(make.assign(own(sum, build.uint(row)), nothing()));
        return;
    }
    body.push_back(make.loop("row", build.uint(rows), [&](ExprId row) {
        std::vector<StmtId> statements;
        std::vector<Numbers> numbers = numbers_of(row, statements);
        const ExprId adds = build.both(build.binary(BinaryOp::not_equal, is_last, build.uint(0)),
                                       build.binary(BinaryOp::less, component(first_of_row(cx, row), 1), size(1)));
        const ExprId parts = build.select(adds, numbers.front().parts, build.uint(0));
        numbers.front().parts = make.let("parts", parts, statements);
        add(row, numbers, statements);
        return statements;
    }));
}

}  // namespace gliftc::lower
