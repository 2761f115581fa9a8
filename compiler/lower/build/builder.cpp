#include "lower/build/builder.h"

#include <algorithm>
#include <cmath>

namespace gliftc::lower {

using namespace ir;

namespace {

bool is_finite(const Value& value) {
    for (const Lane& lane : value.lanes)
        if (!std::isfinite(lane.number)) return false;
    return true;
}

/// Whether the result's component i depends on the operands' components i only. Products with matrices, of which this
/// is not true, are for the caller to exclude.
bool is_component_wise(const Types& types, const Expr& node) {
    switch (node.op) {
    case Op::unary:
    case Op::convert: return true;
    case Op::select: return !types.is_vector(node.type) ? false : true;
    case Op::binary: return node.binary != BinaryOp::equal && node.binary != BinaryOp::not_equal;
    default: return false;
    }
}

}  // namespace

ExprId Builder::integer(TypeId scalar, std::uint64_t value) {
    Expr node;
    node.type = scalar;
    node.bits = value;
    return make(std::move(node));
}

ExprId Builder::zero(TypeId id) {
    const Type type = p.types[id];
    Expr node;
    node.type = id;
    if (p.types.is_scalar(id) || type.kind == TypeKind::enum_) return make(std::move(node));
    node.op = Op::construct;
    if (type.kind == TypeKind::optional) {
        node.op = Op::none;
    } else if (type.kind == TypeKind::vector) {
        node.operands = {zero(type.element)};
    } else if (type.kind == TypeKind::matrix) {
        node.operands.assign(type.count, zero(p.types.vector(type.element, type.rows)));
    } else if (type.kind == TypeKind::array) {
        node.operands.assign(type.count, zero(type.element));
    } else if (type.kind == TypeKind::struct_) {
        std::vector<TypeId> fields;
        for (const StructField& part : p.structs[type.struct_].fields) fields.push_back(part.type);
        for (TypeId part : fields) node.operands.push_back(zero(part));
    }
    return make(std::move(node));
}

ExprId Builder::local(LocalId local) {
    Expr node;
    node.op = Op::local;
    node.type = p.locals[local].type;
    node.local = local;
    return make(std::move(node));
}

ExprId Builder::unary(UnaryOp op, ExprId a) {
    Expr node;
    node.op = Op::unary;
    node.type = type(a);
    node.unary = op;
    return again(node, {a});
}

namespace {

bool compares(BinaryOp op) { return op >= BinaryOp::less && op <= BinaryOp::not_equal; }

}  // namespace

ExprId Builder::binary(BinaryOp op, ExprId a, ExprId b) {
    Expr node;
    node.op = Op::binary;
    node.type = compares(op)                                                ? p.types.bool_
                : p.types.is_vector(type(b)) && !p.types.is_matrix(type(a)) ? type(b)
                                                                            : type(a);
    node.binary = op;
    return again(node, {a, b});
}

ExprId Builder::both(ExprId a, ExprId b) {
    if (!a || !b) return a ? a : b;
    return binary(BinaryOp::logical_and, a, b);
}

ExprId Builder::select(ExprId condition, ExprId yes, ExprId no) {
    Expr node;
    node.op = Op::select;
    node.type = type(yes);
    return again(node, {condition, yes, no});
}

ExprId Builder::construct(TypeId id, Operands parts) {
    Expr node;
    node.op = Op::construct;
    node.type = id;
    return again(node, std::move(parts));
}

ExprId Builder::convert(TypeId id, ExprId a) {
    if (type(a) == id) return a;
    Expr node;
    node.op = Op::convert;
    node.type = id;
    return again(node, {a});
}

ExprId Builder::component(ExprId vector, std::uint32_t lane) {
    if (!p.types.is_vector(type(vector))) return vector;
    if (auto simpler = simpler_component(vector, lane)) return *simpler;
    Expr node;
    node.op = Op::swizzle;
    node.type = p.types.scalar_of(type(vector));
    node.span = p.exprs[vector].span;
    node.lanes[0] = static_cast<std::uint8_t>(lane);
    node.operands = {vector};
    const bool is_known = is_constant(vector);
    const ExprId id = make(std::move(node));
    return is_known ? computed(id) : id;
}

ExprId Builder::index(ExprId whole, ExprId at) {
    Expr node;
    node.op = Op::index;
    const Type& of = p.types[type(whole)];
    node.type = of.kind == TypeKind::matrix ? p.types.vector(of.element, of.rows) : of.element;
    return again(node, {whole, at});
}

ExprId Builder::field(ExprId whole, std::uint32_t slot) {
    Expr node;
    node.op = Op::field;
    node.type = p.structs[p.types[type(whole)].struct_].fields[slot].type;
    node.slot = slot;
    return again(node, {whole});
}

ExprId Builder::field_along(ExprId whole, const std::vector<std::uint32_t>& path) {
    for (std::uint32_t slot : path) whole = field(whole, slot);
    return whole;
}

ExprId Builder::intrinsic(Intrinsic intrinsic, TypeId id, Operands operands) {
    Expr node;
    node.op = Op::intrinsic;
    node.type = id;
    node.intrinsic = intrinsic;
    return again(node, std::move(operands));
}

ExprId Builder::builtin(Builtin builtin, TypeId id) {
    Expr node;
    node.op = Op::builtin;
    node.type = id;
    node.builtin = builtin;
    return make(std::move(node));
}

bool Builder::is_constant(ExprId id) const {
    const Expr& node = p.exprs[id];
    if (node.op == Op::constant || node.op == Op::none) return true;
    if (node.op != Op::construct && node.op != Op::some) return false;
    for (ExprId operand : node.operands)
        if (!is_constant(operand)) return false;
    return true;
}

std::optional<std::uint64_t> Builder::bits_of(ExprId id) const {
    const Expr& node = p.exprs[id];
    if (node.op != Op::constant) return std::nullopt;
    return node.bits;
}

bool Builder::is_true(ExprId id) const { return p.exprs[id].op == Op::constant && p.exprs[id].bits != 0; }
bool Builder::is_false(ExprId id) const { return p.exprs[id].op == Op::constant && p.exprs[id].bits == 0; }

bool Builder::is_number(ExprId id, double value) const {
    const Expr* node = &p.exprs[id];
    while (node->op == Op::construct && node->operands.size() == 1) node = &p.exprs[node->operands[0]];
    if (node->op == Op::construct) {
        for (ExprId operand : node->operands)
            if (!is_number(operand, value)) return false;
        return !node->operands.empty();
    }
    if (node->op != Op::constant || p.types.is_floating(node->type)) return false;
    return static_cast<double>(static_cast<std::int64_t>(node->bits)) == value;
}

/// Whether the value is known to be equal to itself: integers, bools and vectors of them are, floats may be NaNs.
bool Builder::equals_itself(ExprId id) const {
    const bool is_number = p.types.is_scalar(type(id)) || p.types.is_vector(type(id));
    return is_number && !p.types.is_floating(p.types.scalar_of(type(id)));
}

/// Simplifies by identities such as x + 0 = x. Not for floats, where they fail for -0 and NaN.
std::optional<ExprId> Builder::simpler_binary(const Expr& node, ExprId a, ExprId b) {
    auto whole = [&](ExprId id) { return type(id) == node.type; };
    if (compares(node.binary) && equals_itself(a) && is_same(a, b))
        return truth(node.binary == BinaryOp::equal || node.binary == BinaryOp::less_equal ||
                     node.binary == BinaryOp::greater_equal);
    switch (node.binary) {
    case BinaryOp::add:
        // x + (2^32 - n) is x - n, for n below 2^31.
        if (node.type == p.types.uint && p.exprs[b].op == Op::constant && p.exprs[b].bits > 0x80000000u)
            return binary(BinaryOp::subtract, a, uint(0x100000000ull - p.exprs[b].bits));
        [[fallthrough]];
    case BinaryOp::bit_or:
    case BinaryOp::bit_xor:
        if (is_number(a, 0) && whole(b)) return b;
        if (is_number(b, 0) && whole(a)) return a;
        break;
    case BinaryOp::subtract:
    case BinaryOp::shift_left:
    case BinaryOp::shift_right:
        if (is_number(b, 0) && whole(a)) return a;
        break;
    case BinaryOp::multiply:
        if (is_number(a, 1) && whole(b)) return b;
        if (is_number(b, 1) && whole(a)) return a;
        if (is_number(a, 0) || is_number(b, 0)) return zero(node.type);
        break;
    case BinaryOp::divide:
        if (is_number(b, 1) && whole(a)) return a;
        break;
    case BinaryOp::logical_and:
        if (is_true(a) || is_false(b)) return b;
        if (is_true(b) || is_false(a)) return a;
        break;
    case BinaryOp::logical_or:
        if (is_false(a) || is_true(b)) return b;
        if (is_false(b) || is_true(a)) return a;
        break;
    case BinaryOp::less:
        if (is_number(b, 0) && p.types.scalar_of(type(b)) == p.types.uint) return truth(false);
        break;
    case BinaryOp::greater_equal:
        if (is_number(b, 0) && p.types.scalar_of(type(b)) == p.types.uint) return truth(true);
        break;
    case BinaryOp::remainder:
        if (is_number(b, 1)) return zero(node.type);
        break;
    case BinaryOp::less_equal:
        if (is_number(a, 0) && p.types.scalar_of(type(a)) == p.types.uint) return truth(true);
        break;
    case BinaryOp::greater:
        if (is_number(a, 0) && p.types.scalar_of(type(a)) == p.types.uint) return truth(false);
        break;
    case BinaryOp::equal:
    case BinaryOp::not_equal:
    case BinaryOp::bit_and: break;
    }
    return std::nullopt;
}

/// A component of an operation on vectors, as the operation on the operands' components; none if that is not possible,
/// or if it is a select between two values neither of which is a construction.
std::optional<ExprId> Builder::simpler_component(ExprId vector, std::uint32_t lane) {
    const Expr& node = p.exprs[vector];
    if (node.op == Op::swizzle) return component(node.operands[0], node.lanes[lane]);
    if (node.op == Op::construct) {
        if (node.operands.size() == 1) {
            if (!p.types.is_vector(type(node.operands[0]))) return node.operands[0];
            return component(node.operands[0], lane);
        }
        for (ExprId part : node.operands) {
            std::uint32_t count = p.types.components(type(part));
            if (lane < count) return component(part, lane);
            lane -= count;
        }
        return std::nullopt;
    }
    if (node.op == Op::select && p.types.is_vector(type(node.operands[1]))) {
        bool cheap = p.exprs[node.operands[1]].op == Op::construct || p.exprs[node.operands[2]].op == Op::construct;
        if (!cheap) return std::nullopt;
        return select(component(node.operands[0], lane), component(node.operands[1], lane),
                      component(node.operands[2], lane));
    }
    if (node.op == Op::intrinsic &&
        (node.intrinsic == Intrinsic::min || node.intrinsic == Intrinsic::max || node.intrinsic == Intrinsic::clamp)) {
        Operands parts;
        for (ExprId operand : node.operands) parts.push_back(component(operand, lane));
        return intrinsic(node.intrinsic, p.types.scalar_of(node.type), std::move(parts));
    }
    if (!is_component_wise(p.types, node) || node.op == Op::select) return std::nullopt;
    for (ExprId operand : node.operands)
        if (p.types.is_matrix(type(operand))) return std::nullopt;
    Operands parts;
    for (ExprId operand : node.operands) parts.push_back(component(operand, lane));
    Expr scalar = node;
    scalar.type = p.types.scalar_of(node.type);
    return again(scalar, std::move(parts));
}

/// Whether the operation may be folded: its operands are constants, and it is neither a call nor a construction.
bool Builder::is_foldable(const Expr& node, const Operands& operands) const {
    if (operands.empty() || node.op == Op::call || node.op == Op::construct) return false;
    return std::all_of(operands.begin(), operands.end(), [&](ExprId operand) { return is_constant(operand); });
}

/// The expression as a constant, if its value is known and finite; else the expression as it is.
ExprId Builder::computed(ExprId id) {
    auto value = evaluate(p, id);
    if (!value || !is_finite(*value)) return id;
    return materialize(p, *value, p.exprs[id].span);
}

/// Folds an operation on two scalar constants: the most frequent case, done here faster than by the interpreter.
std::optional<ExprId> Builder::constant_binary(const Expr& node, ExprId left, ExprId right) {
    const Expr &a = p.exprs[left], &b = p.exprs[right];
    const bool is_known = a.op == Op::constant && b.op == Op::constant && p.types.is_scalar(a.type) && a.type == b.type;
    if (!is_known) return std::nullopt;
    const Lane lane = apply(p.types, node.binary, a.type, normalize(p.types, a.type, {a.bits, a.number}),
                            normalize(p.types, b.type, {b.bits, b.number}));
    if (!std::isfinite(lane.number)) return std::nullopt;
    Expr made;
    made.type = node.type;
    made.span = node.span;
    made.bits = lane.bits;
    made.number = lane.number;
    return make(std::move(made));
}

// long: a case for each operation
ExprId Builder::again(const Expr& node, Operands operands) {
    switch (node.op) {
    case Op::binary:
        if (auto simpler = simpler_binary(node, operands[0], operands[1])) return *simpler;
        if (auto constant = constant_binary(node, operands[0], operands[1])) return *constant;
        if (auto simpler = simpler_number(node, operands[0], operands[1])) return *simpler;
        break;
    case Op::unary:
        if (node.unary == UnaryOp::logical_not) {
            const Expr& inner = p.exprs[operands[0]];
            if (inner.op == Op::unary && inner.unary == UnaryOp::logical_not) return inner.operands[0];
        }
        break;
    case Op::select:
        if (is_true(operands[0])) return operands[1];
        if (is_false(operands[0])) return operands[2];
        if (node.type == p.types.bool_) {
            if (is_true(operands[1]) && is_false(operands[2])) return operands[0];
            if (is_false(operands[1]) && is_true(operands[2])) return negate(operands[0]);
            if (is_false(operands[2])) return both(operands[0], operands[1]);
            if (is_false(operands[1])) return both(negate(operands[0]), operands[2]);
        }
        break;
    case Op::swizzle: {
        std::uint32_t count = p.types.components(node.type);
        if (count == 1) return component(operands[0], node.lanes[0]);
        bool same = p.types.components(type(operands[0])) == count;
        for (std::uint32_t i = 0; i < count; ++i) same = same && node.lanes[i] == i;
        if (same) return operands[0];
        if (p.exprs[operands[0]].op != Op::construct) break;
        Operands parts;
        for (std::uint32_t i = 0; i < count; ++i) parts.push_back(component(operands[0], node.lanes[i]));
        return construct(node.type, std::move(parts));
    }
    case Op::index:
        if (auto at = bits_of(operands[1])) {
            const Expr& whole = p.exprs[operands[0]];
            if (p.types.is_vector(whole.type)) {
                std::uint32_t last = p.types.components(whole.type) - 1;
                return component(operands[0], static_cast<std::uint32_t>(std::min<std::uint64_t>(*at, last)));
            }
            if (whole.op == Op::construct && *at < whole.operands.size() && p.types.kind(whole.type) == TypeKind::array)
                return whole.operands[*at];
        }
        break;
    case Op::field: {
        const Expr& whole = p.exprs[operands[0]];
        if (whole.op == Op::construct) return whole.operands[node.slot];
        break;
    }
    case Op::construct: {
        // uint2(v.x, v.y) of a two-component v is v.
        if (!p.types.is_vector(node.type) || operands.size() != p.types.components(node.type)) break;
        ExprId whole;
        for (std::uint32_t i = 0; i < operands.size(); ++i) {
            const Expr& part = p.exprs[operands[i]];
            if (part.op != Op::swizzle || p.types.is_vector(part.type) || part.lanes[0] != i)
                return with_operands(node, std::move(operands));
            const Expr& from = p.exprs[part.operands[0]];
            if (!whole) whole = part.operands[0];
            const Expr& first = p.exprs[whole];
            bool same = whole == part.operands[0] ||
                        (from.op == Op::local && first.op == Op::local && from.local == first.local);
            if (!same || from.type != node.type) return with_operands(node, std::move(operands));
        }
        return whole;
    }
    case Op::convert:
        if (type(operands[0]) == node.type) return operands[0];
        break;
    default: break;
    }
    return with_operands(node, std::move(operands));
}

ExprId Builder::with_operands(const Expr& node, Operands operands) {
    const bool is_known = is_foldable(node, operands);
    const ExprId id = p.exprs.add(node);
    p.exprs[id].operands = std::move(operands);
    return is_known ? computed(id) : id;
}

StmtId Builder::again(StmtId id, Parts parts) {
    const Stmt& stmt = p.stmts[id];
    if (parts.target == stmt.target && parts.value == stmt.value && parts.limit == stmt.limit &&
        stmt.body == parts.body && stmt.otherwise == parts.otherwise)
        return id;
    Stmt made = stmt;
    made.target = parts.target;
    made.value = parts.value;
    made.limit = parts.limit;
    made.body = std::move(parts.body);
    made.otherwise = std::move(parts.otherwise);
    return p.stmts.add(std::move(made));
}

Stmt statement(StmtOp op, Span span) {
    Stmt stmt;
    stmt.op = op;
    stmt.span = span;
    return stmt;
}

}  // namespace gliftc::lower
