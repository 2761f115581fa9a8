#include "lower/polynomial.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::size_t term_limit = 64;

void accumulate(Polynomial& sum, const std::vector<ValueNumber>& product, std::uint32_t factor) {
    auto [found, is_new] = sum.try_emplace(product, 0);
    found->second += factor;
    if (found->second == 0) sum.erase(found);
}

Polynomial scaled_sum(const Polynomial& a, const Polynomial& b, std::uint32_t factor) {
    Polynomial result = a;
    for (const auto& [product, count] : b) accumulate(result, product, count * factor);
    return result;
}

std::optional<Polynomial> product_of(const Polynomial& a, const Polynomial& b) {
    if (a.size() * b.size() > term_limit) return std::nullopt;
    Polynomial result;
    for (const auto& [left, m] : a)
        for (const auto& [right, n] : b) {
            std::vector<ValueNumber> both;
            std::merge(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(both));
            accumulate(result, both, m * n);
        }
    return result;
}

}  // namespace

ValueNumber Polynomials::atom(ExprId id) {
    ValueNumber number = numbers_.of(id);
    if (atoms_.emplace(number, id).second) {
        ExprId base = id;
        while (cx.p.exprs[base].op == Op::swizzle) base = cx.p.exprs[base].operands[0];
        uniform_[number] = is_uniform(cx, id) || cx.p.exprs[base].op == Op::parameter;
    }
    return number;
}

/// The sum that a local stands for.
ExprId Polynomials::definition(const Expr& node) {
    if (node.op != Op::local || node.type != cx.p.types.uint) return {};
    const ExprId* found = cx.definitions.find(node.local);
    if (found == nullptr || cx.p.exprs[*found].op != Op::binary || !numbers_.is_fixed(*found)) return {};
    return *found;
}

std::optional<Polynomial> Polynomials::of(ExprId id) {
    if (const auto* found = known_.find(id)) return *found;
    const Expr& node = cx.p.exprs[id];
    std::optional<Polynomial> result;
    if (node.op == Op::constant) {
        result = Polynomial{};
        if (node.bits) result->emplace(std::vector<ValueNumber>{}, static_cast<std::uint32_t>(node.bits));
    } else if (ExprId sum = definition(node)) {
        result = of(sum);
    } else if (node.op == Op::binary && (node.binary == BinaryOp::add || node.binary == BinaryOp::subtract)) {
        auto a = of(node.operands[0]), b = of(node.operands[1]);
        if (a && b) result = scaled_sum(*a, *b, node.binary == BinaryOp::add ? 1u : ~0u);
    } else if (node.op == Op::binary && node.binary == BinaryOp::multiply) {
        auto a = of(node.operands[0]), b = of(node.operands[1]);
        if (a && b) result = product_of(*a, *b);
    } else if (node.op == Op::binary && node.binary == BinaryOp::shift_left &&
               cx.make.bits_of(node.operands[1]).value_or(32) < 32) {
        auto a = of(node.operands[0]);
        if (a) result = product_of(*a, {{{}, 1u << *cx.make.bits_of(node.operands[1])}});
    } else {
        result = Polynomial{{{atom(id)}, 1u}};
    }
    if (result && result->size() > term_limit) result.reset();
    known_.emplace(id, result);
    return result;
}

Polynomial Polynomials::varying(const Polynomial& polynomial) const {
    Polynomial result;
    for (const auto& [product, factor] : polynomial)
        if (std::any_of(product.begin(), product.end(), [&](ValueNumber atom) { return !uniform_.at(atom); }))
            result.emplace(product, factor);
    return result;
}

Polynomials::Difference Polynomials::difference(const Polynomial& a, const Polynomial& b) {
    Polynomial apart = scaled_sum(a, b, ~0u);
    Difference result;
    auto is_minus = [](std::uint32_t factor) { return factor > 0x80000000u; };
    result.is_negative =
        !apart.empty() && std::all_of(apart.begin(), apart.end(), [&](auto& term) { return is_minus(term.second); });
    for (const auto& [product, signed_factor] : apart) {
        std::uint32_t factor = result.is_negative ? 0 - signed_factor : signed_factor;
        ExprId term;
        // From the last on, so that z * (y * x) holds the product that y * x is.
        for (std::size_t i = product.size(); i-- > 0; ++result.operations)
            term = term ? cx.make.multiply(atoms_.at(product[i]), term) : atoms_.at(product[i]);
        if (!term) term = cx.make.uint(factor);
        else if (factor != 1) term = cx.make.multiply(term, cx.make.uint(factor));
        result.amount = result.amount ? cx.make.add(result.amount, term) : term;
        ++result.operations;
    }
    return result;
}

}  // namespace gliftc::lower
