// Polynomials modulo 2^32 over atoms: what is left of a uint expression when sums and products are multiplied out.
#pragma once

#include "lower/number.h"

#include <map>
#include <optional>
#include <vector>

namespace gliftc::lower {

/// Each product of atoms (sorted) with its factor; factors are never zero.
using Polynomial = std::map<std::vector<ValueNumber>, std::uint32_t>;

class Polynomials {
public:
    Polynomials(Context& context, Numbers& numbers) : cx(context), numbers_(numbers) {}

    /// The polynomial of a uint expression that is fixed within the pass; nothing if it grows too large.
    std::optional<Polynomial> of(ExprId id);

    /// The terms that depend on the invocation; two values with the same ones differ by a uniform amount.
    Polynomial varying(const Polynomial& polynomial) const;

    /// a - b, which must have no varying term, as an expression; and whether it is better subtracted than added.
    struct Difference {
        ExprId amount;  ///< absent: zero
        bool is_negative = false;
        unsigned operations = 0;
    };
    Difference difference(const Polynomial& a, const Polynomial& b);

private:
    ValueNumber atom(ExprId id);
    ExprId definition(const ir::Expr& node);

    Context& cx;
    Numbers& numbers_;
    std::map<ValueNumber, ExprId> atoms_;
    std::map<ValueNumber, bool> uniform_;
    FlatMap<ExprId, std::optional<Polynomial>> known_;
};

}  // namespace gliftc::lower
