// How the values of updates are combined before they reach memory.
#pragma once

#include "ir/pass.h"
#include "lower/build/builder.h"

namespace gliftc::lower {

/// The keys by which the values of one update are combined: for minima and maxima of floats ints with the order of
/// floats, so that the result has the same bits in every order; else the values themselves.
class Combination {
public:
    Combination(Builder& builder, const ir::PassBinding& binding, ir::Combine combine);

    /// Whether such values can be combined: 32-bit ints, uints and floats.
    bool is_known() const;
    bool is_of_floats() const { return type() == types().float_; }
    bool is_sum_of_floats() const { return is_of_floats() && combine_ == ir::Combine::add; }
    TypeId type() const { return has_keys_ ? types().int_ : type_; }

    /// Combined with it any key is itself; no value but NaN has it as its key.
    ExprId identity() const;
    ExprId key(ExprId value) const;
    ExprId value(ExprId key) const;
    /// Whether the key changes anything that it is combined with: it is not the identity.
    ExprId changes(ExprId key) const;
    /// Of two keys.
    ExprId of(ExprId one, ExprId other) const;
    /// The atomic operation on keys in workgroup memory.
    ir::Intrinsic intrinsic() const;

private:
    const ir::Types& types() const { return build.p.types; }
    ExprId integer(std::uint64_t bits) const;
    ExprId reordered(ExprId bits) const;

    Builder& build;
    ir::Combine combine_;
    TypeId type_;
    bool has_keys_ = false;
};

}  // namespace gliftc::lower
