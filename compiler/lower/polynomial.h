// Polynomials modulo 2^32 over atoms: what is left of a uint expression when sums and products are multiplied out.
#pragma once

#include "lower/number.h"

#include <deque>
#include <memory_resource>
#include <vector>

namespace gliftc::lower {

/// A product of atoms (sorted), so many times.
struct Term {
    SmallVector<ValueNumber, 4> product;
    std::uint32_t factor = 0;
    bool operator==(const Term&) const = default;
};

/// In the order of the products, each once; factors are never zero. There are hundreds of them a pass, which all go
/// with the Polynomials that made them.
using Polynomial = std::pmr::vector<Term>;

class Polynomials {
public:
    Polynomials(Context& context, Numbers& numbers) : cx(context), numbers_(numbers) {}

    /// The polynomial of a uint expression that is fixed within the pass; none if it grows too large.
    const Polynomial* of(ExprId id);

    /// The terms that depend on the invocation; two values with the same ones differ by a uniform amount.
    Polynomial varying(const Polynomial& polynomial);
    /// Those of `varying` that are more than a choice between zero and a uniform amount.
    Polynomial unchosen(const Polynomial& varying);

    /// a - b, or b - a where that is better subtracted than added.
    struct Difference {
        Polynomial terms;
        bool is_negative = false;
        unsigned operations = 0;
    };
    Difference difference(const Polynomial& a, const Polynomial& b);

    /// The sum as an expression; absent: zero.
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
    FlatMap<ValueNumber, ExprId> atoms_;
    FlatMap<ValueNumber, bool> uniform_;
    FlatMap<ValueNumber, ExprId> choices_;  ///< of atoms that are 1 or 0: the condition
    NodeMap<ExprId, const Polynomial*> known_{cx.first_expr};
    std::deque<Polynomial> made_;  ///< what is known; they stay where they are
};

}  // namespace gliftc::lower
