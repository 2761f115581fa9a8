// Induction variable analysis: finds values that advance by a constant from one element of a row to the next. A row is
// a run of elements that are consecutive along one axis, mostly x.
#pragma once

#include "ir/pass.h"

#include <array>
#include <optional>
#include <unordered_map>

namespace gliftc::lower {

/// How one scalar changes along the row.
struct Slope {
    bool known = false;
    std::int64_t step = 0;                 ///< if known: what is added for each element, modulo 2^32
    std::optional<std::int64_t> constant;  ///< if step is 0: the value, where that is a constant
    std::uint32_t aligned = 0;  ///< if step is 1: the row has this many elements, and the value at its first element is
                                ///< a multiple of it; 0: not known
};

/// The slopes of the components of a scalar or vector. A value of any other type is constant along the row as a whole,
/// or unknown.
using Slopes = std::array<Slope, 4>;

/// The slopes of values within one function or kernel body.
class RowSlopes {
public:
    /// `address` is the local that holds the element's address: its component `axis` advances by one. Rows have `row`
    /// elements and begin at multiples of that; 0: not known.
    RowSlopes(const ir::Program& program, ir::LocalId address, std::uint32_t row = 0, std::uint32_t axis = 0);

    /// Takes note of a statement that every element executes. Called in the order of the statements.
    void learn(const ir::Stmt& stmt);
    /// Takes a uint that is converted to 64 bits for one that does not wrap around along the row. For choices that do
    /// not decide what a kernel computes.
    void assume_no_wrap() { may_wrap_ = false; }
    /// Takes a sum of an aligned value and a steady one for aligned. Also for such choices.
    void assume_aligned() { is_aligned_ = true; }
    /// Says that the local has the same value for the whole row.
    void learn_steady(ir::LocalId local);
    Slopes of(ir::ExprId expr);
    /// Whether the index is a scalar that advances by one.
    bool is_row(ir::ExprId index);
    bool is_steady(ir::ExprId expr);

private:
    RowSlopes(const ir::Program& program, int depth, bool may_wrap)
        : program_(program), depth_(depth), may_wrap_(may_wrap) {}
    Slopes of_call(const ir::Expr& expr);
    Slopes of_construct(const ir::Expr& expr);
    Slopes of_binary(const ir::Expr& expr);
    std::optional<Slope> of_component(const ir::Expr& expr);
    bool is_word(ir::TypeId type) const;
    bool is_kept_by_conversion(ir::TypeId from, ir::TypeId to) const;
    /// Follows a function body; false if that is not possible. A return sets `result`.
    bool run(const std::vector<ir::StmtId>& body, std::optional<Slopes>& result);
    bool assign(ir::ExprId target, const Slopes& value);

    const ir::Program& program_;
    int depth_ = 0;
    bool may_wrap_ = true;
    bool is_aligned_ = false;
    std::unordered_map<ir::LocalId, Slopes> locals_;
};

}  // namespace gliftc::lower
