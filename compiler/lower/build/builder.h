// Makes expressions and folds them as they are made: operations on constants are computed if the result is finite; x +
// 0 and x * 1 of integers, and selects on a constant condition, vanish; components are taken out of constructions and
// pushed through component-wise operations.
#pragma once

#include "ir/evaluate.h"
#include "ir/ir.h"

#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace gliftc::lower {

using ir::ExprId;
using ir::LocalId;
using ir::Op;
using ir::Operands;
using ir::StmtId;
using ir::StmtOp;
using ir::TypeId;

class Builder {
public:
    explicit Builder(ir::Program& program) : p(program) {}

    ExprId uint(std::uint64_t value) { return integer(p.types.uint, value); }
    ExprId integer(TypeId scalar, std::uint64_t value);
    ExprId truth(bool value) { return integer(p.types.bool_, value); }
    ExprId zero(TypeId type);
    ExprId local(LocalId local);
    ExprId unary(ir::UnaryOp op, ExprId a);
    ExprId binary(ir::BinaryOp op, ExprId a, ExprId b);
    ExprId add(ExprId a, ExprId b) { return binary(ir::BinaryOp::add, a, b); }
    ExprId multiply(ExprId a, ExprId b) { return binary(ir::BinaryOp::multiply, a, b); }
    ExprId both(ExprId a, ExprId b);  ///< a && b; an absent operand is true; absent if both are
    ExprId negate(ExprId a) { return unary(ir::UnaryOp::logical_not, a); }
    ExprId select(ExprId condition, ExprId yes, ExprId no);
    ExprId construct(TypeId type, Operands parts);
    ExprId convert(TypeId type, ExprId a);
    ExprId component(ExprId vector, std::uint32_t lane);
    ExprId index(ExprId whole, ExprId at);
    ExprId field(ExprId whole, std::uint32_t slot);
    ExprId field_along(ExprId whole, const std::vector<std::uint32_t>& path);  ///< a field of a field...
    ExprId intrinsic(ir::Intrinsic intrinsic, TypeId type, Operands operands);
    ExprId builtin(ir::Builtin builtin, TypeId type);

    /// The same operation as `node` on other operands, folded.
    ExprId again(const ir::Expr& node, Operands operands);

    /// The expressions and inner statements of a statement, without its arguments.
    struct Parts {
        ExprId target, value, limit;
        std::vector<StmtId> body, otherwise;
    };
    /// A copy of the statement with other parts; the statement itself if the parts are its own.
    StmtId again(StmtId id, Parts parts);

    /// Whether `id` is a constant or `none`, or consists of these alone (Op::construct, Op::some); nothing is
    /// evaluated.
    bool is_constant(ExprId id) const;
    /// Expr::bits of `id`, if it is a constant: the value of an integer, bool or enum. For a float it means nothing:
    /// its value is in Expr::number.
    std::optional<std::uint64_t> bits_of(ExprId id) const;
    bool is_true(ExprId id) const;
    bool is_false(ExprId id) const;
    TypeId type(ExprId id) const { return p.exprs[id].type; }

    ir::Program& p;
    /// The largest values that uint locals may have, where known: for quotients.cpp and loops.cpp.
    std::unordered_map<LocalId, std::uint64_t> limits;

private:
    std::optional<std::uint64_t> limit_of(ExprId id) const;
    std::optional<ExprId> exact_quotient(ExprId value, std::uint64_t divisor);
    bool is_same(ExprId one, ExprId other) const;
    bool equals_itself(ExprId id) const;
    std::optional<ExprId> simpler_quotient(ExprId value, std::uint64_t divisor);
    std::optional<ExprId> simpler_remainder(ExprId value, std::uint64_t divisor);
    std::optional<ExprId> put_together(ExprId quotients, ExprId rest);
    std::optional<ExprId> simpler_number(const ir::Expr& node, ExprId a, ExprId b);
    ExprId make(ir::Expr&& node) { return p.exprs.add(std::move(node)); }
    bool is_foldable(const ir::Expr& node, const Operands& operands) const;
    ExprId computed(ExprId id);
    ExprId with_operands(const ir::Expr& node, Operands operands);
    std::optional<ExprId> simpler_binary(const ir::Expr& node, ExprId a, ExprId b);
    std::optional<ExprId> constant_binary(const ir::Expr& node, ExprId left, ExprId right);
    std::optional<ExprId> simpler_component(ExprId vector, std::uint32_t lane);
    bool is_number(ExprId id, double value) const;
};

/// A statement of this kind with this source location.
ir::Stmt statement(StmtOp op, Span span);

}  // namespace gliftc::lower
