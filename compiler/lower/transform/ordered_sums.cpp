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
    const auto rounds = static_cast<std::uint32_t>(most_rounds / std::bit_ceil(sums));
    return {same_along, axis, made.elements[axis] * (axis == 0 ? made.group[0] : 1),
            axis == 0 ? rounds * lanes_of_tree : rounds};
}

/// Where an invocation's part, and the others of its sum, lie in the memory.
struct OrderedSums::Numbers {
    ExprId parts;    ///< of the sum
    ExprId counter;  ///< the word that counts workgroups
    ExprId groups;   ///< how many share it
    ExprId own;      ///< the word of the invocation's part
    ExprId first;    ///< the word of the sum's first part
    ExprId step;     ///< from one part of the sum to the next; absent: 1
};

OrderedSums::OrderedSums(Context& context, const SeveralElements& made)
    : cx(context), build(context.build), made_(made), slot_(workspace_of(context)) {}

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
OrderedSums::Numbers OrderedSums::numbers(const SumOrder& order, std::vector<StmtId>& body, Span span) {
    Statements make(cx, span);
    Linear sum{build, {}, {}}, part = sum, counter = sum, groups = sum;
    for (std::uint32_t axis = 0; axis < cx.pass.rank; ++axis) {
        if ((order.axes >> axis & 1) == 0) {
            sum.add(address(axis), size(axis));
            counter.add(quotient(address(axis), elements_of_group(axis)),
                        quotient_up(size(axis), elements_of_group(axis)));
            continue;
        }
        const std::uint32_t cut = axis == order.axis ? order.part : 1;
        part.add(quotient(address(axis), cut), named(quotient_up(size(axis), cut), "part_count", axis));
        groups.add(build.uint(0), named(quotient_up(size(axis), elements_of_group(axis)), "group_count", axis));
    }
    const ExprId start = used_ ? used_ : build.uint(0);
    cx.name(sum.limit(), "sum_count");
    cx.name(part.limit(), "part_count");
    cx.name(groups.limit(), "group_count");
    const ExprId first_part = build.add(start, build.multiply(build.uint(2), sum.limit()));
    used_ = build.add(first_part, build.multiply(sum.limit(), part.limit()));
    Numbers result;
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

/// The parts are stored and the workgroup is counted. `is_last` becomes 1 if it is the last one, else 0.
std::vector<StmtId> OrderedSums::stored(const SumOrder& order, const Numbers& of, ExprId sum, ExprId is_last,
                                        Statements make) {
    const Types& types = cx.p.types;
    const ExprId bits = build.intrinsic(Intrinsic::floatBitsToUint, types.uint, {sum});
    const StmtId store = make.store(slot_, index_of(cx, slot_, of.own), bits);
    // The addition releases the stores: those of this invocation, and those that a barrier orders before it.
    const auto count = [&](std::vector<StmtId>& body) {
        const ExprId one_more = build.intrinsic(Intrinsic::atomicAdd, types.uint, {word(of.counter), build.uint(1)});
        const ExprId before = make.let("arrived", one_more, body);
        return build.convert(types.uint, build.binary(BinaryOp::equal, build.add(before, build.uint(1)), of.groups));
    };
    const ExprId in_range = in_range_condition(cx);
    std::vector<StmtId> first;
    if (order.axis != 0) {
        first.push_back(make.assign(is_last, count(first)));
        return {make.where(in_range, {store}), make.assign(sum, nothing()), make.barrier(),
                make.where(is_first_lane(), std::move(first)), make.barrier()};
    }
    // A workgroup beyond the range (line_address of dispatch.cpp) has no part.
    const ExprId found = build.local(make.variable("found", build.uint(0), first));
    std::vector<StmtId> part{store};
    part.push_back(make.assign(found, count(part)));
    first.push_back(make.where(in_range, std::move(part)));
    first.push_back(make.assign(is_last, found));
    first.push_back(make.assign(sum, nothing()));
    return {make.where(is_first_lane(), std::move(first)), make.barrier()};
}

/// Adds parts to `share`: in a tree every 256th, from the invocation's own number on, else all. First several in a
/// turn, whose loads overlap, then one. The turns of several are not for devices that do not skip branches: each
/// workgroup would execute them.
void OrderedSums::add_parts(const SumOrder& order, const Numbers& of, ExprId share, Statements make,
                            std::vector<StmtId>& body) {
    const bool is_tree = order.axis == 0;
    const std::uint32_t stride = is_tree ? lanes_of_tree : 1, several = parts_of_turn * stride;
    // Variables, whose limits are known: else they become parameters, and the rounds would have to be counted.
    const auto limit = [&](std::string_view name, ExprId value, std::uint32_t most) {
        const LocalId local = make.variable(name, value, body);
        build.limits[local] = most;
        return build.local(local);
    };
    const auto add = [&](ExprId first, std::uint32_t count) {
        std::vector<StmtId> statements, adds;
        for (std::uint32_t i = 0; i < count; ++i) {
            const ExprId number = build.add(first, build.uint(i * stride));
            const ExprId at = build.add(of.first, is_tree ? number : build.multiply(number, of.step));
            const ExprId bits = make.let("part", word(at), statements);
            const ExprId part = build.intrinsic(Intrinsic::uintBitsToFloat, cx.p.types.float_, {bits});
            adds.push_back(make.assign(share, build.add(share, part)));
        }
        statements.insert(statements.end(), adds.begin(), adds.end());
        return statements;
    };
    const auto number_at = [&](ExprId start) { return is_tree ? build.add(start, lane()) : start; };
    const ExprId overlaps = build.builtin(Builtin::skips_branches, cx.p.types.bool_);
    const ExprId turns =
        limit("turns", build.select(overlaps, quotient(of.parts, several), build.uint(0)), order.most_parts / several);
    const StmtId loop = make.loop("turn", turns, [&](ExprId turn) {
        return add(number_at(build.multiply(turn, build.uint(several))), parts_of_turn);
    });
    body.push_back(make.where(overlaps, {loop}));
    const ExprId done = make.let("done", build.multiply(turns, build.uint(several)), body);
    const ExprId left = build.binary(BinaryOp::subtract, of.parts, done);
    const ExprId rest = limit("rest", is_tree ? quotient(build.add(left, build.uint(stride - 1)), stride) : left,
                              order.most_parts / stride);
    body.push_back(make.loop("turn", rest, [&](ExprId turn) -> std::vector<StmtId> {
        const ExprId number = number_at(build.add(done, build.multiply(turn, build.uint(stride))));
        if (!is_tree) return add(number, 1);
        return {make.where(build.binary(BinaryOp::less, number, of.parts), add(number, 1))};
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

std::vector<StmtId> OrderedSums::meet(const SumOrder& order, ExprId sum, Span span, WorkgroupTree* tree) {
    Statements make(cx, span);
    std::vector<StmtId> body;
    const Numbers of = numbers(order, body, span);
    const LocalId flag = make.workgroup_array("is_last", cx.p.types.uint, 1);
    const ExprId is_last = build.index(build.local(flag), build.uint(0));
    for (StmtId id : stored(order, of, sum, is_last, make)) body.push_back(id);

    // The last workgroup. The loads of parts may overlap: only the first load is an acquire.
    std::vector<StmtId> last;
    make.let("seen", build.intrinsic(Intrinsic::atomicLoad, cx.p.types.uint, {word(of.counter)}), last);
    const ExprId share = build.local(make.variable("share", nothing(), last));
    if (order.axis == 0) {
        add_parts(order, of, share, make, last);
        // Lavapipe runs the body of an if whose condition does not hold, too: with 0 levels in the other workgroups.
        const ExprId all = build.multiply(is_last, build.uint(tree->most_levels));
        const LocalId levels = make.variable("levels", all, last);
        build.limits[levels] = tree->most_levels;
        for (StmtId id : tree->combine(share, build.local(levels))) last.push_back(id);
    } else {
        std::vector<StmtId> adds;
        add_parts(order, of, share, make, adds);
        adds.push_back(make.assign(sum, share));
        last.push_back(make.where(adds_column(order), std::move(adds)));
    }
    body.push_back(make.where(build.binary(BinaryOp::not_equal, is_last, build.uint(0)), std::move(last)));

    const ExprId several = build.binary(BinaryOp::less, build.uint(1), of.parts);
    const ExprId few = build.binary(BinaryOp::less_equal, of.parts, build.uint(order.most_parts));
    return {make.where(build.both(several, few), std::move(body))};
}

}  // namespace gliftc::lower
