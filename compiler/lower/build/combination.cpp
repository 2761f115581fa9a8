#include "lower/build/combination.h"

namespace gliftc::lower {

using namespace ir;

Combination::Combination(Builder& builder, const PassBinding& binding, Combine combine)
    : build(builder), combine_(combine), type_(binding.element) {
    has_keys_ = type_ == types().float_ && combine != Combine::add;
}

bool Combination::is_known() const { return type_ == types().int_ || type_ == types().uint || type_ == types().float_; }

ExprId Combination::identity() const {
    if (type() == types().float_) return build.unary(UnaryOp::minus, build.zero(types().float_));
    const bool is_signed = type() == types().int_;
    const std::uint64_t low = is_signed ? 0x80000000u : 0u, high = is_signed ? 0x7fffffffu : 0xffffffffu;
    switch (combine_) {
    case Combine::min: return integer(high);
    case Combine::max: return integer(low);
    case Combine::bit_and: return integer(0xffffffffu);
    default: return integer(0);
    }
}

ExprId Combination::key(ExprId value) const {
    if (!has_keys_) return value;
    const ExprId bits = build.intrinsic(Intrinsic::floatBitsToInt, types().int_, {value});
    const ExprId is_number = build.binary(BinaryOp::equal, value, value);
    return build.select(is_number, reordered(bits), identity());
}

ExprId Combination::value(ExprId key) const {
    return has_keys_ ? build.intrinsic(Intrinsic::intBitsToFloat, types().float_, {reordered(key)}) : key;
}

ExprId Combination::changes(ExprId key) const {
    if (type() != types().float_) return build.binary(BinaryOp::not_equal, key, identity());
    const ExprId bits = build.intrinsic(Intrinsic::floatBitsToUint, types().uint, {key});
    return build.binary(BinaryOp::not_equal, bits, build.uint(0x80000000u));  // those of -0
}

ExprId Combination::of(ExprId one, ExprId other) const {
    switch (combine_) {
    case Combine::min: return build.intrinsic(Intrinsic::min, type(), {one, other});
    case Combine::max: return build.intrinsic(Intrinsic::max, type(), {one, other});
    case Combine::bit_and: return build.binary(BinaryOp::bit_and, one, other);
    case Combine::bit_or: return build.binary(BinaryOp::bit_or, one, other);
    case Combine::bit_xor: return build.binary(BinaryOp::bit_xor, one, other);
    default: return build.binary(BinaryOp::add, one, other);
    }
}

Intrinsic Combination::intrinsic() const {
    switch (combine_) {
    case Combine::min: return Intrinsic::atomicMin;
    case Combine::max: return Intrinsic::atomicMax;
    case Combine::bit_and: return Intrinsic::atomicAnd;
    case Combine::bit_or: return Intrinsic::atomicOr;
    case Combine::bit_xor: return Intrinsic::atomicXor;
    default: return Intrinsic::atomicAdd;
    }
}

ExprId Combination::integer(std::uint64_t bits) const {
    if (type() == types().uint) return build.uint(bits);
    return build.integer(types().int_, static_cast<std::uint64_t>(static_cast<std::int32_t>(bits)));
}

/// The bits of floats that are not negative have the order of ints, those of negative ones the reverse.
ExprId Combination::reordered(ExprId bits) const {
    const ExprId sign = build.binary(BinaryOp::shift_right, bits, build.integer(types().int_, 31));
    const ExprId all_but_sign = build.integer(types().int_, 0x7fffffff);
    return build.binary(BinaryOp::bit_xor, bits, build.binary(BinaryOp::bit_and, sign, all_but_sign));
}

}  // namespace gliftc::lower
