#include "lower/analysis/polynomial.h"

#include <algorithm>
#include <compare>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::size_t term_limit = 64;

/// What a term with a condition adds to Difference::operations: so much that differences of uniform terms alone, which
/// the host computes, are preferred.
constexpr unsigned choice_operations = 1000;

std::strong_ordering order(const Term& a, const Term& b) {
    return std::lexicographical_compare_three_way(a.product.begin(), a.product.end(), b.product.begin(),
                                                  b.product.end());
}

using Memory = std::pmr::memory_resource;

/// a + factor * b.
Polynomial scaled_sum(const Polynomial& a, const Polynomial& b, std::uint32_t factor, Memory* memory) {
    Polynomial result(memory);
    result.reserve(a.size() + b.size());
    auto x = a.begin(), y = b.begin();
    const auto add_scaled = [&](const Term& term, std::uint32_t before) {
        if (std::uint32_t sum = before + term.factor * factor) result.push_back({term.product, sum});
    };
    while (x != a.end() && y != b.end()) {
        const std::strong_ordering which = order(*x, *y);
        if (which < 0) result.push_back(*x++);
        else if (which > 0) add_scaled(*y++, 0);
        else add_scaled(*y++, (x++)->factor);
    }
    result.insert(result.end(), x, a.end());
    for (; y != b.end(); ++y) add_scaled(*y, 0);
    return result;
}

Polynomial product_of(const Polynomial& a, const Polynomial& b, Memory* memory) {
    if (a.size() == 1 && a[0].product.empty()) return scaled_sum({}, b, a[0].factor, memory);
    Polynomial result(memory);
    for (const Term& left : a) {
        Polynomial row(memory);
        row.reserve(b.size());
        for (const Term& right : b) {
            Term both{left.product, left.factor * right.factor};
            both.product.append(right.product);
            std::sort(both.product.begin(), both.product.end());
            if (both.factor != 0) row.push_back(std::move(both));
        }
        std::sort(row.begin(), row.end(), [](const Term& x, const Term& y) { return order(x, y) < 0; });
        result = result.empty() ? std::move(row) : scaled_sum(result, row, 1, memory);
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

/// The definition of a uint local, if it is a binary operation or select that does not change within the pass; else
/// absent.
ExprId Polynomials::definition(const Expr& node) {
    if (node.op != Op::local || node.type != cx.p.types.uint) return {};
    const ExprId* found = cx.definitions.find(node.local);
    if (found == nullptr || !numbers_.is_fixed(*found)) return {};
    if (cx.p.exprs[*found].op != Op::binary && cx.p.exprs[*found].op != Op::select) return {};
    return *found;
}

const Polynomial* Polynomials::of(ExprId id) {
    if (const auto* found = known_.find(id)) return *found;
    const Polynomial* result = nullptr;
    if (ExprId sum = definition(cx.p.exprs[id])) {
        result = of(sum);
    } else if (Polynomial made(&memory_); find(id, made) && made.size() <= term_limit) {
        result = &made_.emplace_back(std::move(made));
    }
    known_.emplace(id, result);
    return result;
}

bool Polynomials::find(ExprId id, Polynomial& result) {
    const Expr& node = cx.p.exprs[id];
    if (node.op == Op::constant) {
        if (node.bits) result.push_back({{}, static_cast<std::uint32_t>(node.bits)});
        return true;
    }
    const bool is_sum = node.op == Op::binary && (node.binary == BinaryOp::add || node.binary == BinaryOp::subtract);
    const bool is_product = node.op == Op::binary && node.binary == BinaryOp::multiply;
    const bool is_shift = node.op == Op::binary && node.binary == BinaryOp::shift_left &&
                          cx.build.bits_of(node.operands[1]).value_or(32) < 32;
    if (node.op == Op::select && find_choice(node, result)) return true;
    if (!is_sum && !is_product && !is_shift) {
        result.push_back({{atom(id)}, 1u});
        return true;
    }
    const Polynomial* a = of(node.operands[0]);
    if (is_shift) {
        if (a != nullptr) result = scaled_sum({}, *a, 1u << *cx.build.bits_of(node.operands[1]), &memory_);
        return a != nullptr;
    }
    const Polynomial* b = of(node.operands[1]);
    if (a == nullptr || b == nullptr || (is_product && a->size() * b->size() > term_limit)) return false;
    if (is_product) result = product_of(*a, *b, &memory_);
    else result = scaled_sum(*a, *b, node.binary == BinaryOp::add ? 1u : ~0u, &memory_);
    return true;
}

/// c ? base + step : base with a uniform step is base + c * step, c being 1 or 0.
bool Polynomials::find_choice(const Expr& node, Polynomial& result) {
    const Polynomial *yes = of(node.operands[1]), *no = of(node.operands[2]);
    if (yes == nullptr || no == nullptr) return false;
    const Polynomial step = scaled_sum(*yes, *no, ~0u, &memory_);
    if (!varying(step).empty()) return false;
    const ValueNumber choice = atom(cx.build.select(node.operands[0], cx.build.uint(1), cx.build.uint(0)));
    choices_.emplace(choice, node.operands[0]);
    const Polynomial chosen(1, Term{{choice}, 1}, &memory_);
    result = scaled_sum(*no, product_of(step, chosen, &memory_), 1, &memory_);
    return result.size() <= term_limit;
}

bool Polynomials::is_choice(const Term& term) const {
    const auto varies = [&](ValueNumber atom) { return !*uniform_.find(atom); };
    return std::ranges::count_if(term.product, varies) == 1 &&
           choices_.find(*std::ranges::find_if(term.product, varies)) != nullptr;
}

Polynomial Polynomials::varying(const Polynomial& polynomial) {
    Polynomial result(&memory_);
    result.reserve(polynomial.size());
    for (const Term& term : polynomial)
        if (std::any_of(term.product.begin(), term.product.end(),
                        [&](ValueNumber atom) { return !*uniform_.find(atom); }))
            result.push_back(term);
    return result;
}

Polynomial Polynomials::unchosen(const Polynomial& varying) {
    Polynomial result(&memory_);
    result.reserve(varying.size());
    for (const Term& term : varying)
        if (!is_choice(term)) result.push_back(term);
    return result;
}

Polynomials::Difference Polynomials::difference(const Polynomial& a, const Polynomial& b) {
    Difference result{scaled_sum(a, b, ~0u, &memory_)};
    auto is_minus = [](const Term& term) { return term.factor > 0x80000000u; };
    result.is_negative = !result.terms.empty() && std::all_of(result.terms.begin(), result.terms.end(), is_minus);
    for (Term& term : result.terms) {
        if (result.is_negative) term.factor = 0 - term.factor;
        result.operations += static_cast<unsigned>(term.product.size()) + 1;
        if (is_choice(term)) result.operations += choice_operations;
    }
    return result;
}

ExprId Polynomials::expression(const Polynomial& polynomial) {
    ExprId sum;
    for (const Term& term : polynomial) {
        ExprId product, condition;
        // From the last atom on: x * (y * z), so that y * z is shared with other terms.
        for (std::size_t i = term.product.size(); i-- > 0;) {
            if (const ExprId* found = choices_.find(term.product[i]); found != nullptr && !condition) {
                condition = *found;
                continue;
            }
            ExprId atom = *atoms_.find(term.product[i]);
            product = product ? cx.build.multiply(atom, product) : atom;
        }
        if (!product) product = cx.build.uint(term.factor);
        else if (term.factor != 1) product = cx.build.multiply(product, cx.build.uint(term.factor));
        if (condition) product = cx.build.select(condition, product, cx.build.uint(0));
        sum = sum ? cx.build.add(sum, product) : product;
    }
    return sum;
}

}  // namespace gliftc::lower
