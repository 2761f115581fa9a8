#include "lower/transform/ordered_sums.h"

#include "lower/expand/dispatch.h"
#include "lower/expand/memory.h"

#include <algorithm>
#include <bit>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint32_t lanes_of_tree = 256;
constexpr std::size_t most_rounds = 16384;  ///< of the loops over parts: lavapipe ends an invocation's loops at 65,535

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

/// The parts are stored and the workgroup is counted. `is_last` tells whether it is the last one.
std::vector<StmtId> OrderedSums::stored(const SumOrder& order, const Numbers& of, ExprId sum, ExprId is_last,
                                        Statements make) {
    const Types& types = cx.p.types;
    const auto changed = [&](Intrinsic intrinsic, TypeId type, ExprId at, ExprId value) {
        return build.intrinsic(intrinsic, type, {word(at), value});
    };
    const ExprId bits = build.intrinsic(Intrinsic::floatBitsToUint, types.uint, {sum});
    const StmtId store = make.evaluate(changed(Intrinsic::atomicStore, types.void_, of.own, bits));
    std::vector<StmtId> count;
    const ExprId before =
        make.let("arrived", changed(Intrinsic::atomicAdd, types.uint, of.counter, build.uint(1)), count);
    const ExprId is_it = build.binary(BinaryOp::equal, build.add(before, build.uint(1)), of.groups);
    count.push_back(make.assign(is_last, build.convert(types.uint, is_it)));
    const ExprId in_range = in_range_condition(cx);
    if (order.axis != 0)
        return {make.where(in_range, {store}), make.assign(sum, nothing()), make.barrier(),
                make.where(is_first_lane(), std::move(count)), make.barrier()};
    // A workgroup beyond the range (line_address of dispatch.cpp) has no part.
    count.insert(count.begin(), store);
    return {make.where(is_first_lane(), {make.assign(is_last, build.uint(0)), make.where(in_range, std::move(count)),
                                         make.assign(sum, nothing())}),
            make.barrier()};
}

/// Adds parts to `share`: in a tree every 256th, from the invocation's own number on, else all.
StmtId OrderedSums::loop_over_parts(const SumOrder& order, const Numbers& of, ExprId share, Statements make,
                                    std::vector<StmtId>& before) {
    const bool is_tree = order.axis == 0;
    const std::uint32_t stride = is_tree ? lanes_of_tree : 1;
    // A variable, whose limit is known: else it becomes a parameter, and the rounds would have to be counted.
    const LocalId rounds = make.variable("rounds", quotient_up(of.parts, stride), before);
    build.limits[rounds] = order.most_parts / stride;
    return make.loop("turn", build.local(rounds), [&](ExprId turn) -> std::vector<StmtId> {
        const ExprId number = is_tree ? build.add(build.multiply(turn, build.uint(stride)), lane()) : turn;
        const ExprId at = build.add(of.first, is_tree ? number : build.multiply(number, of.step));
        const ExprId part = build.intrinsic(Intrinsic::uintBitsToFloat, cx.p.types.float_, {word(at)});
        const StmtId add = make.assign(share, build.add(share, part));
        if (!is_tree) return {add};
        return {make.where(build.binary(BinaryOp::less, number, of.parts), {add})};
    });
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

std::vector<StmtId> OrderedSums::meet(const SumOrder& order, ExprId sum, Span span,
                                      const std::function<std::vector<StmtId>(ExprId share)>& tree) {
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
    const StmtId loop = loop_over_parts(order, of, share, make, last);
    if (order.axis == 0) {
        last.push_back(loop);
        for (StmtId id : tree(share)) last.push_back(id);
    } else {
        last.push_back(make.where(adds_column(order), {loop, make.assign(sum, share)}));
    }
    body.push_back(make.where(build.binary(BinaryOp::not_equal, is_last, build.uint(0)), std::move(last)));

    const ExprId several = build.binary(BinaryOp::less, build.uint(1), of.parts);
    const ExprId few = build.binary(BinaryOp::less_equal, of.parts, build.uint(order.most_parts));
    return {make.where(build.both(several, few), std::move(body))};
}

}  // namespace gliftc::lower
