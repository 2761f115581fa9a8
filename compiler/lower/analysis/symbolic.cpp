#include "lower/analysis/symbolic.h"

#include <algorithm>
#include <cassert>

namespace gliftc::lower::symbolic {

namespace {

constexpr std::size_t term_limit = 64;
constexpr std::uint64_t work_limit = 20'000;
constexpr unsigned depth_limit = 24;
/// Sums with larger factors are not compared, lest arithmetic overflows.
constexpr std::int64_t factor_limit = std::int64_t{1} << 40;

void add_term(Sum& sum, const std::vector<Unknown>& product, std::int64_t factor) {
    auto [found, is_new] = sum.try_emplace(product, factor);
    if (!is_new) found->second += factor;
    if (found->second == 0) sum.erase(found);
}

/// The power of the unknown in the product.
std::size_t power_of(const std::vector<Unknown>& product, Unknown unknown) {
    return static_cast<std::size_t>(std::ranges::count(product, unknown));
}

}  // namespace

Sum number(std::int64_t value) {
    Sum sum;
    if (value != 0) sum.emplace(std::vector<Unknown>{}, value);
    return sum;
}

std::optional<std::int64_t> value_of(const Sum& sum) {
    if (sum.empty()) return 0;
    if (sum.size() > 1 || !sum.begin()->first.empty()) return std::nullopt;
    return sum.begin()->second;
}

Sum operator+(const Sum& a, const Sum& b) {
    Sum result = a;
    for (const auto& [product, factor] : b) add_term(result, product, factor);
    return result;
}

Sum operator-(const Sum& a, const Sum& b) {
    Sum result = a;
    for (const auto& [product, factor] : b) add_term(result, product, -factor);
    return result;
}

Sum operator*(const Sum& a, const Sum& b) {
    Sum result;
    for (const auto& [left, x] : a) {
        for (const auto& [right, y] : b) {
            std::vector<Unknown> product = left;
            product.insert(product.end(), right.begin(), right.end());
            std::ranges::sort(product);
            add_term(result, product, x * y);
        }
    }
    return result;
}

Sum replaced(const Sum& sum, Unknown unknown, const Sum& by) {
    Sum result;
    for (const auto& [product, factor] : sum) {
        std::vector<Unknown> rest;
        std::ranges::copy_if(product, std::back_inserter(rest), [&](Unknown each) { return each != unknown; });
        Sum term{{rest, factor}};
        for (std::size_t i = power_of(product, unknown); i > 0; --i) term = term * by;
        result = result + term;
    }
    return result;
}

std::pair<Sum, Sum> divided(const Sum& a, const Sum& b) {
    assert(b.size() == 1);
    const auto& [divisor, by] = *b.begin();
    std::pair<Sum, Sum> result;
    for (const auto& [product, factor] : a) {
        std::vector<Unknown> rest;
        std::ranges::set_difference(product, divisor, std::back_inserter(rest));
        const bool divides = rest.size() + divisor.size() == product.size();
        // Rounds down, so that the factor that remains is not negative.
        std::int64_t quotient = divides ? factor / by : 0;
        if (divides && factor - quotient * by < 0) --quotient;
        if (quotient != 0) add_term(result.first, rest, quotient);
        if (factor != quotient * by) add_term(result.second, product, factor - quotient * by);
    }
    return result;
}

Sum Symbols::add(Data data) {
    unknowns_.push_back(std::move(data));
    return {{{static_cast<Unknown>(unknowns_.size() - 1)}, 1}};
}

Sum Symbols::size(std::int64_t low) { return add({{number(low), std::nullopt}, false}); }

Sum Symbols::varying(Bounds bounds) { return add({std::move(bounds), true}); }

Sum Symbols::applied(Application application, Bounds bounds, bool varies) {
    if (const auto found = applied_.find(application); found != applied_.end()) return found->second;
    return applied_.emplace(std::move(application), add({std::move(bounds), varies})).first->second;
}

bool Symbols::is_exhausted() const { return work_ > work_limit; }

bool Symbols::varies(const Sum& sum) const {
    return std::ranges::any_of(sum, [&](const auto& term) {
        return std::ranges::any_of(term.first, [&](Unknown each) { return unknowns_[each].varies; });
    });
}

/// Eliminates an unknown: the maximum (`high`) or minimum of the sum over all values of the unknown. None if the sum is
/// not known to be monotonic in the unknown, or if the unknown lacks the bound at which the maximum or minimum lies.
std::optional<Sum> Symbols::without(const Sum& sum, Unknown unknown, bool high, unsigned depth) const {
    std::map<std::size_t, Sum> factors;
    for (const auto& [product, factor] : sum) {
        std::vector<Unknown> rest;
        std::ranges::copy_if(product, std::back_inserter(rest), [&](Unknown each) { return each != unknown; });
        if (const std::size_t power = power_of(product, unknown)) add_term(factors[power], rest, factor);
    }
    const Bounds& bounds = unknowns_[unknown].bounds;
    // Even powers are monotonic only over numbers that are not negative; odd ones are not told apart from them.
    if (factors.rbegin()->first > 1 && !(bounds.low && is_natural(*bounds.low, depth + 1))) return std::nullopt;
    bool grows = true, falls = true;
    for (const auto& [power, factor] : factors) {
        grows = grows && is_natural(factor, depth + 1);
        falls = falls && is_natural(Sum{} - factor, depth + 1);
    }
    if (!grows && !falls) return std::nullopt;
    const std::optional<Sum>& end = grows == high ? bounds.high : bounds.low;
    if (!end) return std::nullopt;
    return replaced(sum, unknown, *end);
}

bool Symbols::is_natural(const Sum& sum, unsigned depth) const {
    ++work_;
    if (is_exhausted() || depth > depth_limit || sum.size() > term_limit) return false;
    Unknown latest = 0;
    bool is_constant = true;
    for (const auto& [product, factor] : sum) {
        if (std::abs(factor) > factor_limit) return false;
        if (product.empty()) continue;
        is_constant = false;
        latest = std::max(latest, product.back());
    }
    if (is_constant) return sum.empty() || sum.begin()->second >= 0;
    const std::optional<Sum> least = without(sum, latest, false, depth);
    return least && is_natural(*least, depth + 1);
}

std::optional<Sum> Symbols::extreme(Sum sum, bool high) const {
    while (true) {
        std::optional<Unknown> latest;
        for (const auto& [product, factor] : sum)
            for (Unknown each : product)
                if (unknowns_[each].varies && (!latest || each > *latest)) latest = each;
        if (!latest) return sum;
        std::optional<Sum> next = without(sum, *latest, high, 0);
        if (!next || next->size() > term_limit || is_exhausted()) return std::nullopt;
        sum = std::move(*next);
    }
}

}  // namespace gliftc::lower::symbolic
