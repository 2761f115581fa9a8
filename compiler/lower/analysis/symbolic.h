// Multivariate polynomials with integer coefficients ("sums" of products of unknowns), and proofs that they are not
// negative. lower/analysis/contained.cpp uses them to compare addresses with the extent of a memory, for all sizes at
// once.
//
// An unknown is a size, which has a lower bound and is the same for all addresses; or a number that varies with the
// address; or the result of an operation on unknowns. Numbers are mathematical integers: callers have to handle
// arithmetic that may wrap around.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace gliftc::lower::symbolic {

using Unknown = std::uint32_t;

/// A polynomial: maps each monomial, a sorted list of unknowns, to its factor. The empty list is the constant term. No
/// factor is zero.
using Sum = std::map<std::vector<Unknown>, std::int64_t>;

Sum number(std::int64_t value);
/// The value of a sum without unknowns; absent if it has some.
std::optional<std::int64_t> value_of(const Sum& sum);

Sum operator+(const Sum& a, const Sum& b);
Sum operator-(const Sum& a, const Sum& b);
Sum operator*(const Sum& a, const Sum& b);

/// The bounds of an unknown; absent: none is known.
struct Bounds {
    std::optional<Sum> low, high;
};

/// An operation whose result is an unknown; equal operations on equal operands give the same unknown.
struct Application {
    std::uint32_t operation;
    std::vector<Sum> operands;
    auto operator<=>(const Application&) const = default;
};

class Symbols {
public:
    /// A new unknown that is the same for all addresses and at least `low`.
    Sum size(std::int64_t low);
    /// A new unknown that depends on the address. Its bounds may contain earlier unknowns.
    Sum varying(Bounds bounds);
    /// The unknown for the result of an operation. `bounds` and `varies` are used if it is new.
    Sum applied(Application application, Bounds bounds, bool varies);

    /// Whether the sum is proved to be at least zero for all values of its unknowns.
    bool is_natural(const Sum& sum, unsigned depth = 0) const;
    bool is_at_most(const Sum& a, const Sum& b) const { return is_natural(b - a); }
    bool varies(const Sum& sum) const;
    /// Bounds of the sum that are the same for all addresses; absent: none was found.
    std::optional<Sum> highest(const Sum& sum) const { return extreme(sum, true); }
    std::optional<Sum> lowest(const Sum& sum) const { return extreme(sum, false); }

    const Bounds& bounds(Unknown unknown) const { return unknowns_[unknown].bounds; }

    /// Whether the limit of work is reached: from then on is_natural proves nothing.
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

/// The sum with `by` substituted for an unknown.
Sum replaced(const Sum& sum, Unknown unknown, const Sum& by);

/// Polynomial division by the single term b: a = b * first + second, where b divides no term of `second`. Coefficients
/// are divided as integers and rounded down: 7n by 4n gives 1 and 3n.
std::pair<Sum, Sum> divided(const Sum& a, const Sum& b);

}  // namespace gliftc::lower::symbolic
