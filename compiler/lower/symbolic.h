// Sums of products of unknown numbers with integer factors, and what can be said of their sign: how address arithmetic
// is compared with the size of a memory before either is known.
//
// Unknowns are sizes, which have a lower bound, or vary from address to address between two bounds. Numbers are those
// of mathematics: who makes a sum of what may wrap around says what that means.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace gliftc::lower::symbolic {

using Unknown = std::uint32_t;

/// The factor of each product of unknowns, sorted; that of no unknown is the constant. No factor is zero.
using Sum = std::map<std::vector<Unknown>, std::int64_t>;

Sum number(std::int64_t value);
/// The value of a sum without unknowns.
std::optional<std::int64_t> value_of(const Sum& sum);

Sum operator+(const Sum& a, const Sum& b);
Sum operator-(const Sum& a, const Sum& b);
Sum operator*(const Sum& a, const Sum& b);

struct Bounds {
    std::optional<Sum> low, high;
};

/// An operation whose result is an unknown: the same for the same operands.
struct Application {
    std::uint32_t operation;
    std::vector<Sum> operands;
    auto operator<=>(const Application&) const = default;
};

class Symbols {
public:
    /// A size: the same whatever the address. Sizes are not negative.
    Sum size(std::int64_t low);
    /// A number that depends on the address. Bounds are made of earlier unknowns.
    Sum varying(Bounds bounds);
    /// The unknown for the result of an operation; `bounds` count where it is new.
    Sum applied(Application application, Bounds bounds, bool varies);

    /// Whether the sum is at least zero, whatever its unknowns are. False where that is not found.
    bool is_natural(const Sum& sum, unsigned depth = 0) const;
    bool is_at_most(const Sum& a, const Sum& b) const { return is_natural(b - a); }
    bool varies(const Sum& sum) const;
    /// A bound that does not vary.
    std::optional<Sum> highest(const Sum& sum) const { return extreme(sum, true); }
    std::optional<Sum> lowest(const Sum& sum) const { return extreme(sum, false); }

    const Bounds& bounds(Unknown unknown) const { return unknowns_[unknown].bounds; }

    /// Too much has been asked for: what follows is not worth the time.
    bool is_exhausted() const;

private:
    struct Data {
        Bounds bounds;
        bool varies = false;
    };
    Sum add(Data data);
    std::optional<Sum> extreme(Sum sum, bool high) const;
    std::optional<Sum> without(const Sum& sum, Unknown unknown, bool high, unsigned depth) const;

    std::deque<Data> unknowns_;
    std::map<Application, Sum> applied_;
    mutable std::uint64_t work_ = 0;
};

/// The sum with another one in place of an unknown.
Sum replaced(const Sum& sum, Unknown unknown, const Sum& by);

/// a = b * first + second, the second without terms that b divides; b has one term.
std::pair<Sum, Sum> divided(const Sum& a, const Sum& b);

}  // namespace gliftc::lower::symbolic
