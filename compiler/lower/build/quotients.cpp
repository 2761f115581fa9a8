// Builder: folds quotients and remainders of uint sums. With upper bounds of locals (Builder::limits) it proves that
// sums do not wrap. Then (n * c + offset) / c is n and (n * c + offset) % c is offset, for an offset below c: in a
// kernel over blocks, n is the number of a block, and translators that divide by its size give simple values. And x / c
// * c + x % c is x, and x / c / d is x / (c * d).
#include "lower/build/builder.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint64_t largest = 0xffffffffu;

}  // namespace

/// An upper bound of a uint expression; absent: none is known.
std::optional<std::uint64_t> Builder::limit_of(ExprId id) const {
    const Expr& node = p.exprs[id];
    if (node.type != p.types.uint) return std::nullopt;
    if (node.op == Op::constant) return node.bits;
    if (node.op == Op::local) {
        const auto found = limits.find(node.local);
        return found == limits.end() ? std::nullopt : std::optional(found->second);
    }
    if (node.op != Op::binary) return std::nullopt;
    const auto a = limit_of(node.operands[0]), b = limit_of(node.operands[1]);
    const auto fitting = [](std::uint64_t value) { return value <= largest ? std::optional(value) : std::nullopt; };
    const auto divisor = bits_of(node.operands[1]);
    switch (node.binary) {
    case BinaryOp::add: return a && b ? fitting(*a + *b) : std::nullopt;
    case BinaryOp::multiply: return a && b && (*b == 0 || *a <= largest / *b) ? fitting(*a * *b) : std::nullopt;
    case BinaryOp::divide: return a && divisor && *divisor != 0 ? std::optional(*a / *divisor) : std::nullopt;
    case BinaryOp::remainder:
        if (!divisor || *divisor == 0) return std::nullopt;
        return a ? std::min(*a, *divisor - 1) : *divisor - 1;
    default: return std::nullopt;
    }
}

/// value / divisor, if the value is known to be a multiple of the divisor and not to wrap.
std::optional<ExprId> Builder::exact_quotient(ExprId value, std::uint64_t divisor) {
    const Expr node = p.exprs[value];
    if (const auto bits = bits_of(value); bits && *bits % divisor == 0) return uint(*bits / divisor);
    if (node.op != Op::binary || !limit_of(value)) return std::nullopt;
    if (node.binary == BinaryOp::multiply) {
        const auto factor = bits_of(node.operands[1]);
        if (!factor || *factor % divisor != 0) return std::nullopt;
        return multiply(node.operands[0], uint(*factor / divisor));
    }
    if (node.binary != BinaryOp::add) return std::nullopt;
    const auto a = exact_quotient(node.operands[0], divisor), b = exact_quotient(node.operands[1], divisor);
    return a && b ? std::optional(add(*a, *b)) : std::nullopt;
}

bool Builder::is_same(ExprId one, ExprId other) const {
    if (one == other) return true;
    const Expr &a = p.exprs[one], &b = p.exprs[other];
    if (a.op != b.op || a.type != b.type || a.operands.size() != b.operands.size()) return false;
    if (a.op == Op::constant) return a.bits == b.bits && a.number == b.number;
    if (a.op == Op::local) return a.local == b.local && !p.locals[a.local].is_mutable;
    const bool is_operation = a.op == Op::binary ? a.binary == b.binary : a.op == Op::field && a.slot == b.slot;
    return is_operation &&
           std::ranges::equal(a.operands, b.operands, [&](ExprId x, ExprId y) { return is_same(x, y); });
}

std::optional<ExprId> Builder::simpler_quotient(ExprId value, std::uint64_t divisor) {
    if (const auto limit = limit_of(value); limit && *limit < divisor) return uint(0);
    const Expr node = p.exprs[value];
    if (node.op != Op::binary) return std::nullopt;
    if (node.binary == BinaryOp::divide) {
        const auto inner = bits_of(node.operands[1]);
        if (!inner || *inner == 0 || *inner * divisor > largest) return std::nullopt;
        return binary(BinaryOp::divide, node.operands[0], uint(*inner * divisor));
    }
    if (auto exact = exact_quotient(value, divisor)) return exact;
    if (node.binary != BinaryOp::add || !limit_of(value)) return std::nullopt;
    for (std::size_t i : {0u, 1u}) {
        const auto exact = exact_quotient(node.operands[i], divisor);
        if (exact) return add(*exact, binary(BinaryOp::divide, node.operands[1 - i], uint(divisor)));
    }
    return std::nullopt;
}

std::optional<ExprId> Builder::simpler_remainder(ExprId value, std::uint64_t divisor) {
    if (const auto limit = limit_of(value); limit && *limit < divisor) return value;
    const Expr node = p.exprs[value];
    if (exact_quotient(value, divisor)) return uint(0);
    if (node.op != Op::binary || node.binary != BinaryOp::add || !limit_of(value)) return std::nullopt;
    for (std::size_t i : {0u, 1u})
        if (exact_quotient(node.operands[i], divisor))
            return binary(BinaryOp::remainder, node.operands[1 - i], uint(divisor));
    return std::nullopt;
}

/// x, if `quotients` is x / c * c and `rest` is x % c, so that their sum is x; else absent.
std::optional<ExprId> Builder::put_together(ExprId quotients, ExprId rest) {
    const Expr product = p.exprs[quotients], remainder = p.exprs[rest];
    const bool fits = product.op == Op::binary && product.binary == BinaryOp::multiply && remainder.op == Op::binary &&
                      remainder.binary == BinaryOp::remainder;
    if (!fits) return std::nullopt;
    const auto factor = bits_of(product.operands[1]), divisor = bits_of(remainder.operands[1]);
    if (!factor || *factor == 0 || factor != divisor) return std::nullopt;
    const ExprId whole = binary(BinaryOp::divide, remainder.operands[0], uint(*divisor));
    return is_same(whole, product.operands[0]) ? std::optional(remainder.operands[0]) : std::nullopt;
}

/// Simplifies a quotient, remainder or sum of uints by the identities at the top of this file, if some local has a
/// known bound.
std::optional<ExprId> Builder::simpler_number(const Expr& node, ExprId a, ExprId b) {
    if (limits.empty() || node.type != p.types.uint || type(a) != p.types.uint) return std::nullopt;
    const auto divisor = bits_of(b);
    switch (node.binary) {
    case BinaryOp::divide: return divisor && *divisor != 0 ? simpler_quotient(a, *divisor) : std::nullopt;
    case BinaryOp::remainder: return divisor && *divisor != 0 ? simpler_remainder(a, *divisor) : std::nullopt;
    case BinaryOp::add:
        if (auto whole = put_together(a, b)) return whole;
        return put_together(b, a);
    default: return std::nullopt;
    }
}

}  // namespace gliftc::lower
