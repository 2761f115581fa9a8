// BoundsInterpreter: the cases for expressions. Each scalar of a value is followed separately.
#include "lower/analysis/bounds.h"

#include "ir/chain.h"
#include "ir/evaluate.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;
using symbolic::number;
using symbolic::Sum;
using symbolic::value_of;

namespace {

void append(std::vector<Sum>& to, const std::vector<Sum>& more) { to.insert(to.end(), more.begin(), more.end()); }

Truth both(const Truth& a, const Truth& b) {
    if (a.known && b.known) return {*a.known && *b.known, {}, {}};
    if (a.known) return *a.known ? b : a;
    if (b.known) return *b.known ? a : b;
    Truth result;
    append(result.if_true, a.if_true);
    append(result.if_true, b.if_true);
    return result;
}

std::optional<BinaryOp> comparison_of(Intrinsic intrinsic) {
    switch (intrinsic) {
    case Intrinsic::lessThan: return BinaryOp::less;
    case Intrinsic::lessThanEqual: return BinaryOp::less_equal;
    case Intrinsic::greaterThan: return BinaryOp::greater;
    case Intrinsic::greaterThanEqual: return BinaryOp::greater_equal;
    case Intrinsic::equal: return BinaryOp::equal;
    case Intrinsic::notEqual: return BinaryOp::not_equal;
    default: return std::nullopt;
    }
}

}  // namespace

Parts BoundsInterpreter::of_structure(ExprId id) {
    find_sizes();
    Frame frame;
    Frame* outer = std::exchange(frame_, &frame);
    const Stage* stage = std::exchange(stage_, nullptr);
    Parts parts = of(id);
    frame_ = outer;
    stage_ = stage;
    return parts;
}

Parts BoundsInterpreter::of_size(ExprId id) {
    const bool was_checked = std::exchange(is_checked_, true);
    Parts parts = of_structure(id);
    is_checked_ = was_checked;
    return parts;
}

Parts BoundsInterpreter::of_domain() {
    const bool was_checked = std::exchange(is_checked_, false);
    Parts parts = of_structure(s->domain);
    is_checked_ = was_checked;
    return parts;
}

void BoundsInterpreter::find_sizes() {
    if (std::exchange(has_sizes_, true)) return;
    for (const Memory& memory : s->memories)
        for (const Part& part : of_size(memory.extent)) sizes_.push_back(part.sum);
    for (const MemberStructure& member : s->members)
        for (ExprId argument : member.arguments)
            for (const Part& part : of_size(argument)) sizes_.push_back(part.sum);
}

Parts BoundsInterpreter::member(std::uint32_t slot, TypeId type) {
    Parts parts;
    const std::size_t count = lane_count(p, type);
    for (std::uint32_t lane = 0; lane < count; ++lane) {
        const TypeId scalar = scalar_at(type, lane);
        const bool is_size = scalar == p.types.uint || scalar == p.types.uint64;
        auto found = members_.find({slot, lane});
        if (found == members_.end()) {
            const Sum sum = is_size ? symbols.size(0) : opaque(leaf, {number(slot), number(lane)}, scalar);
            found = members_.emplace(std::pair{slot, lane}, sum).first;
        }
        parts.push_back(part_of(found->second));
    }
    return parts;
}

/// A constructor argument, memory extent or domain of the structure, or of one of its members. If the member is given
/// to the structure and not made by it, the result is unknowns, the same ones for all members that are given the same
/// structure.
Parts BoundsInterpreter::of_leaf(const Expr& node) {
    if (stage_ && node.place.root < stage_->structures.size()) return of_state_leaf(node);
    if (node.place.members.empty()) {
        if (node.op == Op::member) return member(node.slot, node.type);
        if (node.op == Op::memory_extent) return of_size(s->memories[node.slot].extent);
        if (node.op == Op::domain && s->domain) return of_domain();
    } else if (!s->members[*node.place.members.begin()].by_reference) {
        return of_member_leaf(node);
    }
    std::vector<std::uint32_t> path = path_;
    path.insert(path.end(), node.place.members.begin(), node.place.members.end());
    path = made_at(p, *whole_, std::move(path));
    Parts parts;
    const std::size_t count = lane_count(p, node.type);
    for (std::size_t lane = 0; lane < count; ++lane) {
        std::vector<Sum> key{number(static_cast<std::int64_t>(node.op)), number(node.slot),
                             number(static_cast<std::int64_t>(lane))};
        for (std::uint32_t each : path) key.push_back(number(each));
        parts.push_back(part_of(opaque(leaf, std::move(key), scalar_at(node.type, lane))));
    }
    return parts;
}

/// As of_leaf, in a function of a translator, for a structure in the translator's state.
Parts BoundsInterpreter::of_state_leaf(const Expr& node) {
    Expr placed = node;
    placed.place = stage_->structures[node.place.root];
    placed.place.members.append(node.place.members);
    const Stage* const stage = std::exchange(stage_, nullptr);
    Parts parts = of_leaf(placed);
    stage_ = stage;
    return parts;
}

/// As of_leaf, for a member that the structure makes itself, whose constructor arguments are known here.
Parts BoundsInterpreter::of_member_leaf(const Expr& node) {
    const MemberStructure& member = s->members[*node.place.members.begin()];
    const Structure* const made = &p.structures[member.structure];
    std::map<std::pair<std::uint32_t, std::uint32_t>, Sum> given;
    for (std::uint32_t slot = 0; slot < member.arguments.size(); ++slot) {
        const Parts argument = of_size(member.arguments[slot]);
        for (std::uint32_t lane = 0; lane < argument.size(); ++lane) given[{slot, lane}] = argument[lane].sum;
    }
    members_.swap(given);
    const Structure* const outer = std::exchange(s, made);
    path_.push_back(*node.place.members.begin());
    Expr inner = node;
    inner.place.members = {node.place.members.begin() + 1, node.place.members.end()};
    Parts parts = of_leaf(inner);
    path_.pop_back();
    s = outer;
    members_.swap(given);
    return parts;
}

Parts BoundsInterpreter::extent_of_memory() {
    if (s->base.empty()) return of_size(s->memories[s->via_memory].extent);
    Expr domain;
    domain.op = Op::domain;
    domain.type = physical_type(p, *s);
    domain.place.members = s->base;
    return of_leaf(domain);
}

Parts BoundsInterpreter::of_construct(const Expr& node) {
    Parts parts;
    for (ExprId operand : node.operands) {
        Parts more = of(operand);
        parts.insert(parts.end(), more.begin(), more.end());
    }
    const std::size_t count = lane_count(p, node.type);
    if (parts.size() == 1) parts.assign(count, Part(parts[0]));
    if (parts.size() != count) return unknown(node.type);
    return parts;
}

Parts BoundsInterpreter::of_comparison(const Expr& node) {
    const Parts a = of(node.operands[0]), b = of(node.operands[1]);
    const TypeId scalar = p.types.scalar_of(p.exprs[node.operands[0]].type);
    if (node.binary == BinaryOp::logical_and || node.binary == BinaryOp::logical_or) {
        const bool is_and = node.binary == BinaryOp::logical_and;
        Truth truth = is_and ? both(a[0].truth, b[0].truth) : inverse(both(inverse(a[0].truth), inverse(b[0].truth)));
        if (truth.known) return {part_of(*truth.known)};
        return {{opaque(operation_of(node.binary), {a[0].sum, b[0].sum}, p.types.bool_), std::move(truth)}};
    }
    const bool is_number = p.types.is_integer(scalar) || p.types.kind(scalar) == TypeKind::enum_;
    if (a.size() != 1 || b.size() != 1 || !is_number) return unknown(node.type);
    Truth truth = compared(node.binary, a[0].sum, b[0].sum);
    if (truth.known) return {part_of(*truth.known)};
    return {{opaque(operation_of(node.binary), {a[0].sum, b[0].sum}, p.types.bool_), std::move(truth)}};
}

Parts BoundsInterpreter::of_binary(const Expr& node) {
    if (node.binary >= BinaryOp::less && node.binary <= BinaryOp::not_equal) return of_comparison(node);
    if (node.binary == BinaryOp::logical_and || node.binary == BinaryOp::logical_or) return of_comparison(node);
    const TypeId scalar = p.types.scalar_of(node.type);
    if (!p.types.is_integer(scalar) || p.types.is_matrix(node.type)) return unknown(node.type);
    const Parts a = of(node.operands[0]), b = of(node.operands[1]);
    Parts result;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
        result.push_back(calculated(node, scalar, a[a.size() == 1 ? 0 : i], b[b.size() == 1 ? 0 : i]));
    return result;
}

Parts BoundsInterpreter::of_unary(const Expr& node) {
    if (node.unary == UnaryOp::logical_not) {
        const Part inner = of(node.operands[0])[0];
        if (inner.truth.known) return {part_of(!*inner.truth.known)};
        return {{opaque(logical_inversion, {inner.sum}, p.types.bool_), inverse(inner.truth)}};
    }
    const TypeId scalar = p.types.scalar_of(node.type);
    Parts parts = of(node.operands[0]);
    for (Part& part : parts) {
        const auto value = value_of(part.sum);
        const std::int64_t result = value ? (node.unary == UnaryOp::minus ? -*value : ~*value) : 0;
        if (value && p.types.is_integer(scalar))
            part = part_of(number(static_cast<std::int64_t>(
                normalize(p.types, scalar, {.bits = static_cast<std::uint64_t>(result)}).bits)));
        else part = part_of(opaque(node.unary == UnaryOp::minus ? minus : bit_inversion, {part.sum}, scalar));
    }
    return parts;
}

Parts BoundsInterpreter::of_convert(const Expr& node) {
    const TypeId from = p.types.scalar_of(p.exprs[node.operands[0]].type), to = p.types.scalar_of(node.type);
    if (!p.types.is_integer(from) || !p.types.is_integer(to)) return unknown(node.type);
    Parts parts = of(node.operands[0]);
    for (Part& part : parts) {
        if (const auto value = value_of(part.sum)) {
            const Lane lane = ir::convert(p.types, from, to, {.bits = static_cast<std::uint64_t>(*value)});
            part = part_of(number(static_cast<std::int64_t>(lane.bits)));
            continue;
        }
        const bool widens = from == p.types.uint && to == p.types.uint64 && fits(part.sum);
        if (!widens) part = part_of(opaque(conversion, {part.sum, number(static_cast<std::int64_t>(to.index))}, to));
    }
    return parts;
}

Parts BoundsInterpreter::of_select(const Expr& node) {
    const Parts conditions = of(node.operands[0]);
    if (conditions.size() > 1) {
        const Parts yes = of(node.operands[1]), no = of(node.operands[2]);
        Parts result;
        for (std::size_t i = 0; i < yes.size(); ++i) result.push_back(chosen(conditions[i], yes[i], no[i]));
        return result;
    }
    const Part& condition = conditions[0];
    if (condition.truth.known) return of(node.operands[*condition.truth.known ? 1 : 2]);
    const auto locals = frame_->locals;
    assume(condition.truth.if_true);
    const Parts yes = of(node.operands[1]);
    frame_->locals = locals;
    assume(condition.truth.if_false);
    const Parts no = of(node.operands[2]);
    frame_->locals = locals;
    if (yes.empty() || no.empty()) return joined(yes, no);
    Parts result;
    for (std::size_t i = 0; i < yes.size(); ++i) result.push_back(chosen(condition, yes[i], no[i]));
    return result;
}

Parts BoundsInterpreter::of_index(const Expr& node) {
    const Parts whole = of(node.operands[0]);
    const auto at = value_of(of(node.operands[1])[0].sum);
    const std::size_t count = std::max<std::size_t>(1, lane_count(p, node.type));
    if (at && *at >= 0 && (static_cast<std::size_t>(*at) + 1) * count <= whole.size()) {
        const auto begin = whole.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(*at) * count);
        return {begin, begin + static_cast<std::ptrdiff_t>(count)};
    }
    Parts result;
    for (std::size_t i = 0; i < count && i < whole.size(); ++i) result.push_back(whole[i]);
    for (std::size_t i = count; i < whole.size(); ++i) result[i % count] = joined(result[i % count], whole[i]);
    return result;
}

/// A component-wise comparison of vectors.
Parts BoundsInterpreter::of_lanes(BinaryOp op, const Parts& a, const Parts& b, std::size_t count) {
    Parts parts;
    for (std::size_t lane = 0; lane < count; ++lane) {
        const Sum &x = a[a.size() == 1 ? 0 : lane].sum, &y = b[b.size() == 1 ? 0 : lane].sum;
        Truth truth = compared(op, x, y);
        parts.push_back(truth.known ? part_of(*truth.known)
                                    : Part{opaque(operation_of(op), {x, y}, p.types.bool_), std::move(truth)});
    }
    return parts;
}

Part BoundsInterpreter::of_all(Intrinsic which, const Parts& conditions) {
    const bool is_all = which == Intrinsic::all;
    Truth truth{is_all, {}, {}};
    std::vector<Sum> sums;
    for (const Part& part : conditions) {
        truth = is_all ? both(truth, part.truth) : inverse(both(inverse(truth), inverse(part.truth)));
        sums.push_back(part.sum);
    }
    if (truth.known) return part_of(*truth.known);
    return {opaque(operation_of(which), std::move(sums), p.types.bool_), std::move(truth)};
}

Parts BoundsInterpreter::of_intrinsic(const Expr& node) {
    std::vector<Parts> operands;
    for (ExprId operand : node.operands) operands.push_back(of(operand));
    const TypeId scalar = p.types.scalar_of(p.exprs[node.operands[0]].type);
    const std::size_t count = lane_count(p, node.type);
    if (node.intrinsic == Intrinsic::all || node.intrinsic == Intrinsic::any)
        return {of_all(node.intrinsic, operands[0])};
    if (const auto op = comparison_of(node.intrinsic); op && p.types.is_integer(scalar))
        return of_lanes(*op, operands[0], operands[1], count);
    Parts parts;
    for (std::size_t lane = 0; lane < count; ++lane) {
        const auto at = [&](std::size_t i) { return operands[i][operands[i].size() == 1 ? 0 : lane].sum; };
        if (scalar == p.types.uint && node.intrinsic == Intrinsic::min) {
            parts.push_back(part_of(smaller(at(0), at(1))));
        } else if (scalar == p.types.uint && node.intrinsic == Intrinsic::max) {
            parts.push_back(part_of(larger(at(0), at(1))));
        } else if (scalar == p.types.uint && node.intrinsic == Intrinsic::clamp) {
            parts.push_back(part_of(smaller(larger(at(0), at(1)), at(2))));
        } else {
            std::vector<Sum> sums{number(static_cast<std::int64_t>(lane))};
            for (const Parts& operand : operands)
                for (const Part& part : operand) sums.push_back(part.sum);
            parts.push_back(part_of(opaque(operation_of(node.intrinsic), std::move(sums), scalar_at(node.type, lane))));
        }
    }
    return parts;
}

Parts BoundsInterpreter::of_call(const Expr& node) {
    const Function& function = p.functions[node.function];
    if (!function.structures.empty() || !function.extern_name.empty() || function.grouped()) return unknown(node.type);
    std::vector<Parts> arguments;
    for (ExprId operand : node.operands) arguments.push_back(of(operand));
    return call(node.function, std::move(arguments));
}

Parts BoundsInterpreter::of(ExprId id) {
    const Expr& node = p.exprs[id];
    if (symbols.is_exhausted()) return unknown(node.type);
    switch (node.op) {
    case Op::constant:
        if (p.types.kind(node.type) == TypeKind::bool_) return {part_of(node.bits != 0)};
        if (p.types.is_floating(node.type)) return unknown(node.type);
        return {part_of(number(static_cast<std::int64_t>(node.bits)))};
    case Op::local: {
        const auto found = frame_->locals.find(node.local);
        return found == frame_->locals.end() ? unknown(node.type) : found->second;
    }
    case Op::construct: return of_construct(node);
    case Op::binary: return of_binary(node);
    case Op::unary: return of_unary(node);
    case Op::convert: return of_convert(node);
    case Op::select: return of_select(node);
    case Op::swizzle: {
        const Parts whole = of(node.operands[0]);
        Parts parts;
        for (std::uint32_t i = 0; i < p.types.components(node.type); ++i) parts.push_back(whole[node.lanes[i]]);
        return parts;
    }
    case Op::index: return of_index(node);
    case Op::intrinsic: return of_intrinsic(node);
    case Op::call: return of_call(node);
    case Op::none: return {};
    case Op::some: return of(node.operands[0]);
    case Op::value: {
        Parts parts = of(node.operands[0]);
        return parts.empty() ? unknown(node.type) : parts;  // the value of none: no path reaches this
    }
    case Op::state: return of_structure(stage_->scalars[node.slot]);
    case Op::member:
    case Op::memory_extent:
    case Op::domain: return of_leaf(node);
    default: return unknown(node.type);
    }
}

}  // namespace gliftc::lower
