// Polynomials modulo 2^32: the normal form of uint expressions, with sums, products and left shifts by constants
// multiplied out. Their variables are atoms: values that are none of these. A select between values that differ by a
// uniform amount is a sum, too: c ? base + step : base is base + c * step, the atom c being 1 or 0.
#pragma once

#include "lower/analysis/number.h"

#include <deque>
#include <memory_resource>
#include <vector>

namespace gliftc::lower {

/// A monomial: factor * the product of atoms (sorted value numbers).
struct Term {
    SmallVector<ValueNumber, 4> product;
    std::uint32_t factor = 0;
    bool operator==(const Term&) const = default;
};

/// Monomials ordered by their products, each product once; no factor is zero. Their memory belongs to the Polynomials
/// that made them.
using Polynomial = std::pmr::vector<Term>;

class Polynomials {
public:
    Polynomials(Context& context, Numbers& numbers) : cx(context), numbers_(numbers) {}

    /// The polynomial of a uint expression that does not change within the pass; null if it is too large.
    const Polynomial* of(ExprId id);

    /// The terms that depend on the invocation. Two values for which these are equal differ by a uniform amount.
    Polynomial varying(const Polynomial& polynomial);
    /// The terms of `varying` without those that are a condition (1 or 0) times a uniform amount.
    Polynomial unchosen(const Polynomial& varying);

    /// The terms of a - b. If all its factors are above 2^31, and so stand for negative numbers, those of b - a
    /// instead, which are then to be subtracted.
    struct Difference {
        Polynomial terms;
        bool is_negative = false;  ///< `terms` are b - a
        unsigned operations = 0;   ///< cost of computing the terms
    };
    Difference difference(const Polynomial& a, const Polynomial& b);

    /// The polynomial as an expression; absent if it is zero.
    ExprId expression(const Polynomial& polynomial);

private:
    ValueNumber atom(ExprId id);
    ExprId definition(const ir::Expr& node);
    bool find(ExprId id, Polynomial& result);
    bool find_choice(const ir::Expr& node, Polynomial& result);
    bool is_choice(const Term& term) const;

    Context& cx;
    Numbers& numbers_;
    std::pmr::monotonic_buffer_resource memory_;
    FlatMap<ValueNumber, ExprId> atoms_;    ///< an expression for each atom
    FlatMap<ValueNumber, bool> uniform_;    ///< whether the atom is the same for all invocations
    FlatMap<ValueNumber, ExprId> choices_;  ///< for atoms `condition ? 1 : 0`: the condition
    NodeMap<ExprId, const Polynomial*> known_{cx.first_expr};
    std::deque<Polynomial> made_;  ///< a deque, so that pointers in known_ stay valid
};

}  // namespace gliftc::lower
