#include "lower/bounds.h"

#include "ir/evaluate.h"
#include "lower/unroll.h"

#include <algorithm>
#include <bit>

namespace gliftc::lower {

using namespace ir;
using symbolic::number;
using symbolic::operator+;
using symbolic::operator-;
using symbolic::operator*;
using symbolic::Sum;
using symbolic::value_of;

namespace {

constexpr unsigned depth_limit = 32;
constexpr std::int64_t largest = 0xffffffff;

/// What opaque unknowns are results of, beside binary operators and intrinsics.
enum Operation : std::uint32_t { binary_op = 0, intrinsic_op = 100, not_zero = 1000, choice, leaf, conversion, inversion };

std::uint32_t operation_of(BinaryOp op) { return binary_op + static_cast<std::uint32_t>(op); }

Part part_of(Sum sum) { return {std::move(sum), {}}; }
Part part_of(bool known) { return {number(known ? 1 : 0), {known, {}, {}}}; }

void append(std::vector<Sum>& to, const std::vector<Sum>& more) { to.insert(to.end(), more.begin(), more.end()); }

Truth inverse(const Truth& truth) {
    Truth result{std::nullopt, truth.if_false, truth.if_true};
    if (truth.known) result.known = !*truth.known;
    return result;
}

Truth both(const Truth& a, const Truth& b) {
    if (a.known && b.known) return {*a.known && *b.known, {}, {}};
    if (a.known) return *a.known ? b : a;
    if (b.known) return *b.known ? a : b;
    Truth result;
    append(result.if_true, a.if_true);
    append(result.if_true, b.if_true);
    return result;
}

}  // namespace

// ------------------------------------------------------------------------------------------------------ values

TypeId Following::scalar_at(TypeId type, std::size_t lane) const {
    const Type& of = p.types[type];
    if (of.kind == TypeKind::array) return scalar_at(of.element, lane % std::max<std::size_t>(1, lane_count(p, of.element)));
    if (of.kind == TypeKind::struct_) {
        for (const StructField& field : p.structs[of.index].fields) {
            const std::size_t count = lane_count(p, field.type);
            if (lane < count) return scalar_at(field.type, lane);
            lane -= count;
        }
    }
    return p.types.is_vector(type) || p.types.is_matrix(type) ? p.types.scalar_of(type) : type;
}

Part Following::unknown_scalar(TypeId scalar) {
    const bool is_unsigned = scalar == p.types.uint || scalar == p.types.uint64;
    return part_of(symbols.varying({is_unsigned ? std::optional(number(0)) : std::nullopt, std::nullopt}));
}

Parts Following::unknown(TypeId type) {
    if (p.types.kind(type) == TypeKind::optional) type = p.types[type].element;
    Parts parts;
    const std::size_t count = lane_count(p, type);
    for (std::size_t i = 0; i < count; ++i) parts.push_back(unknown_scalar(scalar_at(type, i)));
    return parts;
}

/// The result of an operation that is not followed, on operands that do not vary.
Sum Following::opaque(std::uint32_t operation, std::vector<Sum> operands, TypeId scalar) {
    const bool is_unsigned = scalar == p.types.uint || scalar == p.types.uint64;
    const std::optional<Sum> low = is_unsigned ? std::optional(number(0)) : std::nullopt;
    const bool varies = std::ranges::any_of(operands, [&](const Sum& each) { return symbols.varies(each); });
    return symbols.applied({operation, std::move(operands)}, {low, std::nullopt}, varies);
}

/// Whether a sum of unsigned numbers is what the program computes: sizes are taken to be.
bool Following::fits(const Sum& sum) {
    if (!symbols.varies(sum)) return true;
    if (sum.size() == 1 && sum.begin()->first.size() == 1 && sum.begin()->second == 1) return true;
    const std::optional<Sum> high = symbols.highest(sum);
    if (!high) return false;
    if (const auto value = value_of(*high)) return *value <= largest;
    return std::ranges::any_of(members_, [&](const auto& member) { return symbols.is_at_most(*high, member.second); });
}

Sum Following::at_least_one(const Sum& sum) {
    if (symbols.is_natural(sum - number(1))) return sum;
    if (value_of(sum)) return number(1);
    return symbols.applied({not_zero, {sum}}, {number(1), std::nullopt}, symbols.varies(sum));
}

/// a - b of unsigned numbers, which is not what it says where b is larger.
Sum Following::difference(const Sum& a, const Sum& b) {
    if (fits(a) && symbols.is_natural(a - b)) return a - b;
    return opaque(operation_of(BinaryOp::subtract), {a, b}, p.types.uint);
}

Sum Following::quotient(const Sum& a, const Sum& b) {
    const Sum by = at_least_one(b);
    const std::uint32_t operation = operation_of(BinaryOp::divide);
    const auto high_over = [&](const Sum& sum) {
        const std::optional<Sum> high = symbols.varies(sum) ? symbols.highest(sum) : std::nullopt;
        return high && !symbols.varies(by) ? std::optional(quotient(*high, by)) : high;
    };
    const bool is_plain = by.size() == 1 && by.begin()->second > 0 && !symbols.varies(by) && fits(a);
    if (!is_plain)
        return symbols.applied({operation, {a, by}}, {number(0), high_over(a)}, symbols.varies(a) || symbols.varies(by));
    const auto [whole, rest] = symbolic::divided(a, by);
    if (rest.empty() || (symbols.is_natural(rest) && symbols.is_natural(by - rest - number(1)))) return whole;
    if (symbols.is_natural(Sum{} - rest - number(1)) && symbols.is_natural(by + rest)) return whole - number(1);
    std::optional<Sum> low;
    if (symbols.is_natural(rest)) low = number(symbols.is_natural(rest - by) ? 1 : 0);
    return whole + symbols.applied({operation, {rest, by}}, {low, high_over(rest)}, symbols.varies(rest));
}

Sum Following::remainder(const Sum& a, const Sum& b) {
    const Sum by = at_least_one(b);
    if (fits(a) && symbols.is_natural(by - a - number(1))) return a;
    const auto x = value_of(a), y = value_of(by);
    if (x && y) return number(*x % *y);
    const bool varies = symbols.varies(by);
    return symbols.applied({operation_of(BinaryOp::remainder), {a, by}},
                           {number(0), varies ? symbols.highest(a) : std::optional(by - number(1))},
                           varies || symbols.varies(a));
}

Sum Following::smaller(const Sum& a, const Sum& b) {
    if (symbols.is_at_most(a, b)) return a;
    if (symbols.is_at_most(b, a)) return b;
    std::optional<Sum> low;
    for (int least : {0, 1})
        if (symbols.is_natural(a - number(least)) && symbols.is_natural(b - number(least))) low = number(least);
    const std::optional<Sum> high = !symbols.varies(b) ? b : !symbols.varies(a) ? a : symbols.highest(a);
    return symbols.applied({intrinsic_op + static_cast<std::uint32_t>(Intrinsic::min), {a, b}}, {low, high},
                           symbols.varies(a) || symbols.varies(b));
}

Sum Following::larger(const Sum& a, const Sum& b) {
    if (symbols.is_at_most(a, b)) return b;
    if (symbols.is_at_most(b, a)) return a;
    const bool varies = symbols.varies(a) || symbols.varies(b);
    std::optional<Sum> high;
    const auto x = symbols.highest(a), y = symbols.highest(b);
    if (varies && x && y) high = symbols.is_at_most(*x, *y) ? y : symbols.is_at_most(*y, *x) ? x : std::nullopt;
    return symbols.applied({intrinsic_op + static_cast<std::uint32_t>(Intrinsic::max), {a, b}},
                           {symbols.varies(b) ? symbols.lowest(a) : b, high}, varies);
}

Part Following::joined(const Part& a, const Part& b) {
    if (a.sum == b.sum) return a;
    symbolic::Bounds bounds;
    const auto x = symbols.highest(a.sum), y = symbols.highest(b.sum);
    if (x && y) bounds.high = symbols.is_at_most(*x, *y) ? y : symbols.is_at_most(*y, *x) ? x : std::nullopt;
    if (symbols.is_natural(a.sum) && symbols.is_natural(b.sum)) bounds.low = number(0);
    return part_of(symbols.varying(std::move(bounds)));
}

/// One of two values; what is empty maps nowhere.
Parts Following::joined(const Parts& a, const Parts& b) {
    if (a.empty() || b.empty()) return a.empty() ? b : a;
    Parts result;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) result.push_back(joined(a[i], b[i]));
    return result;
}

Part Following::chosen(const Part& condition, const Part& yes, const Part& no) {
    if (condition.truth.known) return *condition.truth.known ? yes : no;
    if (yes.sum == no.sum) return yes;
    const bool varies = symbols.varies(condition.sum) || symbols.varies(yes.sum) || symbols.varies(no.sum);
    if (varies) return joined(yes, no);
    std::optional<Sum> low;
    for (int least : {0, 1})
        if (symbols.is_natural(yes.sum - number(least)) && symbols.is_natural(no.sum - number(least)))
            low = number(least);
    return part_of(symbols.applied({choice, {condition.sum, yes.sum, no.sum}}, {low, std::nullopt}, false));
}

Truth Following::compared(BinaryOp op, const Sum& a, const Sum& b) {
    if (!fits(a) || !fits(b)) return {};
    const auto at_most = [&](const Sum& x, const Sum& y, std::int64_t distance) {  // x + distance <= y
        return y - x - number(distance);
    };
    Truth truth;
    switch (op) {
    case BinaryOp::less: truth = {std::nullopt, {at_most(a, b, 1)}, {at_most(b, a, 0)}}; break;
    case BinaryOp::less_equal: truth = {std::nullopt, {at_most(a, b, 0)}, {at_most(b, a, 1)}}; break;
    case BinaryOp::greater: truth = {std::nullopt, {at_most(b, a, 1)}, {at_most(a, b, 0)}}; break;
    case BinaryOp::greater_equal: truth = {std::nullopt, {at_most(b, a, 0)}, {at_most(a, b, 1)}}; break;
    case BinaryOp::equal:
        if (a == b) truth.known = true;
        if (symbols.is_natural(at_most(a, b, 1)) || symbols.is_natural(at_most(b, a, 1))) truth.known = false;
        truth.if_true = {at_most(a, b, 0), at_most(b, a, 0)};
        return truth;
    case BinaryOp::not_equal: return inverse(compared(BinaryOp::equal, a, b));
    default: return truth;
    }
    if (symbols.is_natural(truth.if_true[0])) truth.known = true;
    else if (symbols.is_natural(truth.if_false[0])) truth.known = false;
    return truth;
}

// ------------------------------------------------------------------------------------------------- expressions

Parts Following::of_structure(ExprId id) {
    Frame frame;
    Frame* outer = std::exchange(frame_, &frame);
    const Stage* stage = std::exchange(stage_, nullptr);
    Parts parts = of(id);
    frame_ = outer;
    stage_ = stage;
    return parts;
}

Parts Following::member(std::uint32_t slot, TypeId type) {
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

/// What the structure is made with; what its own structures are made with has no more than a name.
Parts Following::of_leaf(const Expr& node) {
    if (node.place.root == 0 && node.place.members.empty()) {
        if (node.op == Op::member) return member(node.slot, node.type);
        if (node.op == Op::memory_extent) return of_structure(s.memories[node.slot].extent);
        if (node.op == Op::domain && s.domain) return of_structure(s.domain);
    }
    Parts parts;
    const std::size_t count = lane_count(p, node.type);
    for (std::size_t lane = 0; lane < count; ++lane) {
        std::vector<Sum> key{number(static_cast<std::int64_t>(node.op)), number(node.slot),
                             number(static_cast<std::int64_t>(lane))};
        for (std::uint32_t each : node.place.members) key.push_back(number(each));
        parts.push_back(part_of(opaque(leaf, std::move(key), scalar_at(node.type, lane))));
    }
    return parts;
}

Parts Following::of_construct(const Expr& node) {
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

Part Following::calculated(const Expr& node, TypeId scalar, const Part& a, const Part& b) {
    const auto x = value_of(a.sum), y = value_of(b.sum);
    if (x && y && p.types.is_integer(scalar)) {
        const Lane lane = apply(p.types, node.binary, scalar, {.bits = static_cast<std::uint64_t>(*x)},
                                {.bits = static_cast<std::uint64_t>(*y)});
        return part_of(number(static_cast<std::int64_t>(lane.bits)));
    }
    const std::uint32_t operation = operation_of(node.binary);
    if (scalar != p.types.uint) return part_of(opaque(operation, {a.sum, b.sum}, scalar));
    const bool is_shift = y && *y < 32;
    switch (node.binary) {
    case BinaryOp::add: return part_of(a.sum + b.sum);
    case BinaryOp::multiply: return part_of(a.sum * b.sum);
    case BinaryOp::subtract: return part_of(difference(a.sum, b.sum));
    case BinaryOp::divide: return part_of(quotient(a.sum, b.sum));
    case BinaryOp::remainder: return part_of(remainder(a.sum, b.sum));
    case BinaryOp::shift_left:
        if (is_shift) return part_of(a.sum * number(std::int64_t{1} << *y));
        break;
    case BinaryOp::shift_right:
        if (is_shift) return part_of(quotient(a.sum, number(std::int64_t{1} << *y)));
        break;
    case BinaryOp::bit_and: {
        const std::optional<Sum> high = !symbols.varies(b.sum) ? b.sum : symbols.highest(a.sum);
        return part_of(symbols.applied({operation, {a.sum, b.sum}}, {number(0), high},
                                       symbols.varies(a.sum) || symbols.varies(b.sum)));
    }
    case BinaryOp::bit_or:
    case BinaryOp::bit_xor: {
        const auto high = symbols.highest(a.sum), other = symbols.highest(b.sum);
        const auto m = high ? value_of(*high) : std::nullopt, n = other ? value_of(*other) : std::nullopt;
        if (!m || !n) break;
        const auto bits = static_cast<std::uint64_t>(*m | *n);
        return part_of(symbols.applied({operation, {a.sum, b.sum}},
                                       {number(0), number(static_cast<std::int64_t>(std::bit_ceil(bits + 1)) - 1)},
                                       symbols.varies(a.sum) || symbols.varies(b.sum)));
    }
    default: break;
    }
    return part_of(opaque(operation, {a.sum, b.sum}, scalar));
}

Parts Following::of_comparison(const Expr& node) {
    const Parts a = of(node.operands[0]), b = of(node.operands[1]);
    const TypeId scalar = p.types.scalar_of(p.exprs[node.operands[0]].type);
    if (node.binary == BinaryOp::logical_and || node.binary == BinaryOp::logical_or) {
        const bool is_and = node.binary == BinaryOp::logical_and;
        Truth truth = is_and ? both(a[0].truth, b[0].truth)
                             : inverse(both(inverse(a[0].truth), inverse(b[0].truth)));
        if (truth.known) return {part_of(*truth.known)};
        return {{opaque(operation_of(node.binary), {a[0].sum, b[0].sum}, p.types.bool_), std::move(truth)}};
    }
    if (a.size() != 1 || b.size() != 1 || !p.types.is_integer(scalar)) return unknown(node.type);
    Truth truth = compared(node.binary, a[0].sum, b[0].sum);
    if (truth.known) return {part_of(*truth.known)};
    return {{opaque(operation_of(node.binary), {a[0].sum, b[0].sum}, p.types.bool_), std::move(truth)}};
}

Parts Following::of_binary(const Expr& node) {
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

Parts Following::of_unary(const Expr& node) {
    if (node.unary == UnaryOp::logical_not) {
        const Part inner = of(node.operands[0])[0];
        if (inner.truth.known) return {part_of(!*inner.truth.known)};
        return {{opaque(inversion, {inner.sum}, p.types.bool_), inverse(inner.truth)}};
    }
    const TypeId scalar = p.types.scalar_of(node.type);
    Parts parts = of(node.operands[0]);
    for (Part& part : parts) {
        const auto value = value_of(part.sum);
        const std::int64_t result = value ? (node.unary == UnaryOp::minus ? -*value : ~*value) : 0;
        if (value && p.types.is_integer(scalar))
            part = part_of(number(static_cast<std::int64_t>(
                normalize(p.types, scalar, {.bits = static_cast<std::uint64_t>(result)}).bits)));
        else part = part_of(opaque(inversion + 1 + static_cast<std::uint32_t>(node.unary), {part.sum}, scalar));
    }
    return parts;
}

Parts Following::of_convert(const Expr& node) {
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

Parts Following::of_select(const Expr& node) {
    const Part condition = of(node.operands[0])[0];
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

Parts Following::of_index(const Expr& node) {
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

Parts Following::of_intrinsic(const Expr& node) {
    std::vector<Parts> operands;
    for (ExprId operand : node.operands) operands.push_back(of(operand));
    const auto lane_of = [&](std::size_t operand, std::size_t lane) {
        return operands[operand][operands[operand].size() == 1 ? 0 : lane];
    };
    const TypeId scalar = p.types.scalar_of(p.exprs[node.operands[0]].type);
    const std::size_t count = lane_count(p, node.type);
    const auto each_lane = [&](auto&& make) {
        Parts parts;
        for (std::size_t lane = 0; lane < count; ++lane) parts.push_back(make(lane));
        return parts;
    };
    const auto comparison = [&](BinaryOp op) {
        if (!p.types.is_integer(scalar)) return unknown(node.type);
        return each_lane([&](std::size_t lane) -> Part {
            const Sum a = lane_of(0, lane).sum, b = lane_of(1, lane).sum;
            Truth truth = compared(op, a, b);
            if (truth.known) return part_of(*truth.known);
            return {opaque(operation_of(op), {a, b}, p.types.bool_), std::move(truth)};
        });
    };
    const bool is_unsigned = scalar == p.types.uint;
    switch (node.intrinsic) {
    case Intrinsic::min:
        if (!is_unsigned) break;
        return each_lane([&](std::size_t i) { return part_of(smaller(lane_of(0, i).sum, lane_of(1, i).sum)); });
    case Intrinsic::max:
        if (!is_unsigned) break;
        return each_lane([&](std::size_t i) { return part_of(larger(lane_of(0, i).sum, lane_of(1, i).sum)); });
    case Intrinsic::clamp:
        if (!is_unsigned) break;
        return each_lane([&](std::size_t i) {
            return part_of(smaller(larger(lane_of(0, i).sum, lane_of(1, i).sum), lane_of(2, i).sum));
        });
    case Intrinsic::lessThan: return comparison(BinaryOp::less);
    case Intrinsic::lessThanEqual: return comparison(BinaryOp::less_equal);
    case Intrinsic::greaterThan: return comparison(BinaryOp::greater);
    case Intrinsic::greaterThanEqual: return comparison(BinaryOp::greater_equal);
    case Intrinsic::equal: return comparison(BinaryOp::equal);
    case Intrinsic::notEqual: return comparison(BinaryOp::not_equal);
    case Intrinsic::all:
    case Intrinsic::any: {
        const bool is_all = node.intrinsic == Intrinsic::all;
        Truth truth{is_all, {}, {}};
        std::vector<Sum> sums;
        for (const Part& part : operands[0]) {
            truth = is_all ? both(truth, part.truth) : inverse(both(inverse(truth), inverse(part.truth)));
            sums.push_back(part.sum);
        }
        if (truth.known) return {part_of(*truth.known)};
        return {{opaque(intrinsic_op + static_cast<std::uint32_t>(node.intrinsic), std::move(sums), p.types.bool_),
                 std::move(truth)}};
    }
    default: break;
    }
    return each_lane([&](std::size_t lane) {
        std::vector<Sum> sums{number(static_cast<std::int64_t>(lane))};
        for (const Parts& parts : operands)
            for (const Part& part : parts) sums.push_back(part.sum);
        return part_of(opaque(intrinsic_op + static_cast<std::uint32_t>(node.intrinsic), std::move(sums),
                              scalar_at(node.type, lane)));
    });
}

Parts Following::of_call(const Expr& node) {
    const Function& function = p.functions[node.function];
    if (!function.structures.empty() || !function.extern_name.empty() || function.grouped()) return unknown(node.type);
    std::vector<Parts> arguments;
    for (ExprId operand : node.operands) arguments.push_back(of(operand));
    return call(node.function, std::move(arguments));
}

Parts Following::of(ExprId id) {
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
    case Op::some:
    case Op::value: return of(node.operands[0]);
    case Op::state: return of_structure(stage_->scalars[node.slot]);
    case Op::member:
    case Op::memory_extent:
    case Op::domain: return of_leaf(node);
    default: return unknown(node.type);
    }
}

// -------------------------------------------------------------------------------------------------- statements

Parts Following::call(FunctionId id, std::vector<Parts> arguments) {
    const Function& function = p.functions[id];
    if (depth_ > depth_limit) return unknown(function.result);
    Frame frame;
    for (std::size_t i = 0; i < function.params.size() && i < arguments.size(); ++i)
        frame.locals[function.params[i]] = std::move(arguments[i]);
    Frame* outer = std::exchange(frame_, &frame);
    ++depth_;
    run(function.body);
    --depth_;
    Parts result = frame.is_followed ? frame.returned.value_or(Parts{}) : unknown(function.result);
    frame_ = outer;
    return result;
}

std::optional<Parts> Following::translated(Parts address) {
    for (const Stage& stage : s.via) {
        stage_ = &stage;
        address = call(p.translators[stage.translator].translate, {std::move(address)});
        if (address.empty()) return std::nullopt;
    }
    stage_ = nullptr;
    return address;
}

/// Numbers that vary get the bounds that the facts, each a sum that is at least zero, give them.
void Following::assume(const std::vector<Sum>& facts) {
    for (const Sum& fact : facts) {
        for (const auto& [product, factor] : fact) {
            if (product.size() != 1 || factor != -1) continue;
            const symbolic::Unknown each = product[0];
            const Sum own{{product, 1}};
            const Sum high = fact + own;
            const symbolic::Bounds bounds = symbols.bounds(each);
            const bool is_alone = std::ranges::none_of(
                high, [&](const auto& term) { return std::ranges::count(term.first, each) != 0; });
            const bool is_known = bounds.high && symbols.is_at_most(*bounds.high, high);
            if (!symbols.varies(own) || !is_alone || is_known) continue;
            const Sum bounded = symbols.varying({bounds.low, high});
            for (auto& [local, parts] : frame_->locals)
                for (Part& part : parts) part.sum = symbolic::replaced(part.sum, each, bounded);
        }
    }
}

void Following::give_up() { frame_->is_followed = false; }

void Following::assign(ExprId target, const Parts& value) {
    const Expr& node = p.exprs[target];
    if (node.op == Op::local) {
        frame_->locals[node.local] = value;
        return;
    }
    const Expr& base = p.exprs[node.operands[0]];
    if (base.op != Op::local || (node.op != Op::index && node.op != Op::swizzle)) return give_up();
    Parts& whole = frame_->locals[base.local];
    const auto at = node.op == Op::index ? value_of(of(node.operands[1])[0].sum) : std::nullopt;
    if (node.op == Op::index && !at) {
        whole = unknown(base.type);
        return;
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
        const std::size_t slot =
            node.op == Op::swizzle ? node.lanes[i] : static_cast<std::size_t>(*at) * value.size() + i;
        if (slot < whole.size()) whole[slot] = value[i];
    }
}

void Following::run_if(const Stmt& stmt) {
    const Part condition = of(stmt.value)[0];
    if (condition.truth.known) return run(*condition.truth.known ? stmt.body : stmt.otherwise);
    const auto before = frame_->locals;
    assume(condition.truth.if_true);
    run(stmt.body);
    const bool has_left = std::exchange(frame_->has_left, false);
    const auto after = std::exchange(frame_->locals, before);
    assume(condition.truth.if_false);
    run(stmt.otherwise);
    if (has_left) return;  // what follows comes from the other side, or from nowhere
    if (std::exchange(frame_->has_left, false)) {
        frame_->locals = after;
        return;
    }
    for (auto& [local, parts] : frame_->locals) {
        const auto other = after.find(local);
        if (other == after.end() || other->second.size() != parts.size()) continue;
        for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = chosen(condition, other->second[i], parts[i]);
    }
}

void Following::run_for(const Stmt& stmt) {
    const auto first = value_of(of(stmt.value)[0].sum), limit = value_of(of(stmt.limit)[0].sum);
    const bool is_known = first && limit && *limit - *first <= static_cast<std::int64_t>(unroll_limit);
    if (!is_known || leaves_loop(p, stmt.body)) return give_up();
    for (std::int64_t i = *first; i < *limit && !frame_->has_left && frame_->is_followed; ++i) {
        frame_->locals[stmt.local] = {part_of(number(i))};
        run(stmt.body);
    }
}

void Following::run(const std::vector<StmtId>& body) {
    for (StmtId id : body) {
        if (frame_->has_left || !frame_->is_followed) return;
        const Stmt& stmt = p.stmts[id];
        switch (stmt.op) {
        case StmtOp::let: {
            const TypeId type = p.locals[stmt.local].type;
            Parts zeros(lane_count(p, type), part_of(number(0)));
            frame_->locals[stmt.local] = stmt.value ? of(stmt.value) : std::move(zeros);
            break;
        }
        case StmtOp::assign: assign(stmt.target, of(stmt.value)); break;
        case StmtOp::return_: {
            const Parts value = stmt.value ? of(stmt.value) : Parts{};
            frame_->returned = frame_->returned ? joined(*frame_->returned, value) : value;
            frame_->has_left = true;
            break;
        }
        case StmtOp::if_: run_if(stmt); break;
        case StmtOp::block: run(stmt.body); break;
        case StmtOp::for_: run_for(stmt); break;
        default: give_up();
        }
    }
}

}  // namespace gliftc::lower
