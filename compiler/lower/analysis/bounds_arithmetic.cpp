// BoundsInterpreter: arithmetic on symbolic numbers. Each operation gives a sum, or an unknown with bounds.
#include "ir/evaluate.h"
#include "lower/analysis/bounds.h"

#include <algorithm>
#include <bit>
#include <ranges>

namespace gliftc::lower {

using namespace ir;
using symbolic::number;
using symbolic::operator+;
using symbolic::operator-;
using symbolic::operator*;
using symbolic::Sum;
using symbolic::value_of;

namespace {

constexpr std::int64_t largest = 0xffffffff;

}  // namespace

TypeId BoundsInterpreter::scalar_at(TypeId type, std::size_t lane) const {
    const Type& of = p.types[type];
    if (of.kind == TypeKind::array)
        return scalar_at(of.element, lane % std::max<std::size_t>(1, lane_count(p, of.element)));
    if (of.kind == TypeKind::struct_) {
        for (const StructField& field : p.structs[of.struct_].fields) {
            const std::size_t count = lane_count(p, field.type);
            if (lane < count) return scalar_at(field.type, lane);
            lane -= count;
        }
    }
    return p.types.is_vector(type) || p.types.is_matrix(type) ? p.types.scalar_of(type) : type;
}

Part BoundsInterpreter::unknown_scalar(TypeId scalar) {
    const bool is_unsigned = scalar == p.types.uint || scalar == p.types.uint64;
    return part_of(symbols.varying({is_unsigned ? std::optional(number(0)) : std::nullopt, std::nullopt}));
}

Parts BoundsInterpreter::unknown(TypeId type) {
    if (p.types.kind(type) == TypeKind::optional) type = p.types[type].element;
    Parts parts;
    const std::size_t count = lane_count(p, type);
    for (std::size_t i = 0; i < count; ++i) parts.push_back(unknown_scalar(scalar_at(type, i)));
    return parts;
}

/// An unknown for the result of an operation that is not followed further.
Sum BoundsInterpreter::opaque(std::uint32_t operation, std::vector<Sum> operands, TypeId scalar) {
    const bool is_unsigned = scalar == p.types.uint || scalar == p.types.uint64;
    const std::optional<Sum> low = is_unsigned ? std::optional(number(0)) : std::nullopt;
    const bool varies = std::ranges::any_of(operands, [&](const Sum& each) { return symbols.varies(each); });
    return symbols.applied({operation, std::move(operands)}, {low, std::nullopt}, varies);
}

/// Whether the program's wrapping arithmetic is known to give the same number as the sum. It is known if the sum is a
/// single unknown, which stands for one value of the program; if it is part of a size that the runtime checks
/// (is_checked_); or if it has an upper bound that is no larger than 2^32 - 1, than a constructor's argument, or than
/// one of sizes_.
bool BoundsInterpreter::fits(const Sum& sum) {
    if (is_checked_ && !symbols.varies(sum)) return true;
    if (sum.size() == 1 && sum.begin()->first.size() == 1 && sum.begin()->second == 1) return true;
    const std::optional<Sum> high = symbols.varies(sum) ? symbols.highest(sum) : sum;
    if (!high) return false;
    if (const auto value = value_of(*high)) return *value <= largest;
    const auto bounds = [&](const Sum& size) { return symbols.is_at_most(*high, size); };
    return std::ranges::any_of(members_ | std::views::values, bounds) || std::ranges::any_of(sizes_, bounds);
}

Sum BoundsInterpreter::at_least_one(const Sum& sum) {
    if (fits(sum) && symbols.is_natural(sum - number(1))) return sum;
    if (value_of(sum)) return number(1);
    return symbols.applied({not_zero, {sum}}, {number(1), std::nullopt}, symbols.varies(sum));
}

/// The difference of unsigned numbers: the sum a - b if it is known that b is no larger than a and that a does not
/// exceed 2^32 - 1; else an unknown, since the difference may wrap.
Sum BoundsInterpreter::difference(const Sum& a, const Sum& b) {
    if (fits(a) && symbols.is_natural(a - b)) return a - b;
    return opaque(operation_of(BinaryOp::subtract), {a, b}, p.types.uint);
}

Sum BoundsInterpreter::quotient(const Sum& a, const Sum& b) {
    const Sum by = at_least_one(b);
    const bool is_plain = by.size() == 1 && by.begin()->second > 0 && !symbols.varies(by) && fits(by);
    if (is_plain && fits(a)) return exact_quotient(a, by);
    std::optional<Sum> high = symbols.varies(a) ? symbols.highest(a) : std::nullopt;
    // Wrapping makes numbers smaller only, so the bound holds even if `a` wraps.
    if (high && is_plain) high = exact_quotient(*high, by);
    return symbols.applied({operation_of(BinaryOp::divide), {a, by}}, {number(0), high},
                           symbols.varies(a) || symbols.varies(by));
}

/// The quotient of sums that do not wrap; `by` has one term, which is positive and the same for all addresses.
Sum BoundsInterpreter::exact_quotient(const Sum& a, const Sum& by) {
    const std::uint32_t operation = operation_of(BinaryOp::divide);
    const auto high_over = [&](const Sum& sum) {
        const std::optional<Sum> high = symbols.varies(sum) ? symbols.highest(sum) : std::nullopt;
        return high ? std::optional(exact_quotient(*high, by)) : high;
    };
    const auto [whole, rest] = symbolic::divided(a, by);
    if (rest.empty() || (symbols.is_natural(rest) && symbols.is_natural(by - rest - number(1)))) return whole;
    if (symbols.is_natural(Sum{} - rest - number(1)) && symbols.is_natural(by + rest)) return whole - number(1);
    std::optional<Sum> low;
    if (symbols.is_natural(rest)) low = number(symbols.is_natural(rest - by) ? 1 : 0);
    std::optional<Sum> high = high_over(rest);
    // The constant term of `rest` is below the divisor, so it increases the quotient by one at most.
    const auto constant = rest.find({});
    if (constant != rest.end() && constant->second > 0 && rest.size() > 1 && value_of(by) && !high)
        high = exact_quotient(rest - number(constant->second), by) + number(1);
    return whole + symbols.applied({operation, {rest, by}}, {low, high}, symbols.varies(rest));
}

Sum BoundsInterpreter::remainder(const Sum& a, const Sum& b) {
    const Sum by = at_least_one(b);
    if (fits(a) && fits(by) && symbols.is_natural(by - a - number(1))) return a;
    const auto x = value_of(a), y = value_of(by);
    if (x && y) return number(*x % *y);
    const bool varies = symbols.varies(by);
    return symbols.applied({operation_of(BinaryOp::remainder), {a, by}},
                           {number(0), varies ? symbols.highest(a) : std::optional(by - number(1))},
                           varies || symbols.varies(a));
}

/// A lower bound of both numbers: 1 if both are known to be at least 1, else 0; none if one of them may be negative.
std::optional<Sum> BoundsInterpreter::least_of(const Sum& a, const Sum& b) {
    if (!symbols.is_natural(a) || !symbols.is_natural(b)) return std::nullopt;
    const auto is_positive = [&](const Sum& sum) { return fits(sum) && symbols.is_natural(sum - number(1)); };
    return number(is_positive(a) && is_positive(b) ? 1 : 0);
}

Sum BoundsInterpreter::smaller(const Sum& a, const Sum& b) {
    if (fits(a) && fits(b)) {
        if (symbols.is_at_most(a, b)) return a;
        if (symbols.is_at_most(b, a)) return b;
    }
    std::optional<Sum> high = !symbols.varies(b) ? b : !symbols.varies(a) ? a : symbols.highest(a);
    // The smaller of two numbers is no more than half of their sum.
    if (symbols.varies(a) && !symbols.varies(a + b)) high = exact_quotient(a + b, number(2));
    return symbols.applied({operation_of(Intrinsic::min), {a, b}}, {least_of(a, b), high},
                           symbols.varies(a) || symbols.varies(b));
}

Sum BoundsInterpreter::larger(const Sum& a, const Sum& b) {
    if (fits(a) && fits(b)) {
        if (symbols.is_at_most(a, b)) return b;
        if (symbols.is_at_most(b, a)) return a;
    }
    const bool varies = symbols.varies(a) || symbols.varies(b);
    std::optional<Sum> high;
    const auto x = symbols.highest(a), y = symbols.highest(b);
    if (varies && x && y) high = symbols.is_at_most(*x, *y) ? y : symbols.is_at_most(*y, *x) ? x : std::nullopt;
    std::optional<Sum> low = number(0);
    if (!symbols.varies(b) && fits(b)) low = b;
    else if (fits(a)) low = symbols.lowest(a);
    return symbols.applied({operation_of(Intrinsic::max), {a, b}}, {low, high}, varies);
}

Part BoundsInterpreter::joined(const Part& a, const Part& b) {
    if (a.sum == b.sum) return a;
    symbolic::Bounds bounds;
    const auto x = symbols.highest(a.sum), y = symbols.highest(b.sum);
    if (x && y) bounds.high = symbols.is_at_most(*x, *y) ? y : symbols.is_at_most(*y, *x) ? x : std::nullopt;
    if (symbols.is_natural(a.sum) && symbols.is_natural(b.sum)) bounds.low = number(0);
    return part_of(symbols.varying(std::move(bounds)));
}

/// A value that may be either of two. Empty Parts stand for `none`, an unmapped address; the result is then the other
/// value.
Parts BoundsInterpreter::joined(const Parts& a, const Parts& b) {
    if (a.empty() || b.empty()) return a.empty() ? b : a;
    Parts result;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) result.push_back(joined(a[i], b[i]));
    return result;
}

Part BoundsInterpreter::chosen(const Part& condition, const Part& yes, const Part& no) {
    if (condition.truth.known) return *condition.truth.known ? yes : no;
    if (yes.sum == no.sum) return yes;
    const bool varies = symbols.varies(condition.sum) || symbols.varies(yes.sum) || symbols.varies(no.sum);
    if (varies) return joined(yes, no);
    const std::optional<Sum> low = least_of(yes.sum, no.sum);
    return part_of(symbols.applied({choice, {condition.sum, yes.sum, no.sum}}, {low, std::nullopt}, false));
}

Truth BoundsInterpreter::compared(BinaryOp op, const Sum& a, const Sum& b) {
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

/// A number that is the same for all addresses and has every bit set that may be set in `sum`; none: not known.
std::optional<Sum> BoundsInterpreter::bits_of(const Sum& sum) {
    if (!symbols.varies(sum)) return sum;
    if (sum.size() == 1 && sum.begin()->first.size() == 1) {
        const auto& [product, factor] = *sum.begin();
        const bool is_shift = factor > 0 && std::has_single_bit(static_cast<std::uint64_t>(factor));
        const auto found = bits_.find(product[0]);
        if (found != bits_.end() && is_shift) return found->second * number(factor);
        if (is_shift && factor > 1) {
            const std::optional<Sum> bits = bits_of({{product, 1}});
            return bits ? std::optional(*bits * number(factor)) : std::nullopt;
        }
    }
    std::optional<Sum> high = symbols.highest(sum);
    if (!high || !fits(*high)) return std::nullopt;
    // Set all bits below the highest one.
    for (int distance : {1, 2, 4, 8, 16})
        high = bits_together(BinaryOp::bit_or, *high, quotient(*high, number(std::int64_t{1} << distance)));
    return high;
}

/// A bit operation on two numbers that are the same for all addresses.
Sum BoundsInterpreter::bits_together(BinaryOp op, const Sum& a, const Sum& b) {
    const auto x = value_of(a), y = value_of(b);
    if ((!x || !y) && op == BinaryOp::bit_and)
        return symbols.applied({operation_of(op), {a, b}}, {number(0), x ? a : b}, false);
    if (!x || !y) return opaque(operation_of(op), {a, b}, p.types.uint);
    return number(op == BinaryOp::bit_and ? *x & *y : op == BinaryOp::bit_or ? *x | *y : *x ^ *y);
}

Sum BoundsInterpreter::of_bits(const Expr& node, const Sum& a, const Sum& b) {
    if (!symbols.varies(a) && !symbols.varies(b)) return bits_together(node.binary, a, b);
    const std::optional<Sum> x = bits_of(a), y = bits_of(b);
    std::optional<Sum> high;
    if (x && y) high = bits_together(node.binary == BinaryOp::bit_and ? BinaryOp::bit_and : BinaryOp::bit_or, *x, *y);
    else if (node.binary == BinaryOp::bit_and) high = x ? x : y;
    const Sum result = symbols.applied({operation_of(node.binary), {a, b}}, {number(0), high}, true);
    if (high) bits_.emplace(result.begin()->first[0], *high);
    return result;
}

Part BoundsInterpreter::calculated(const Expr& node, TypeId scalar, const Part& a, const Part& b) {
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
    case BinaryOp::bit_and:
    case BinaryOp::bit_or:
    case BinaryOp::bit_xor: return part_of(of_bits(node, a.sum, b.sum));
    default: break;
    }
    return part_of(opaque(operation, {a.sum, b.sum}, scalar));
}

}  // namespace gliftc::lower
