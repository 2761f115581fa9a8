// Intrinsics: printed as a function or operator of GLSL, or as a helper where GLSL has none, leaves the result open, or
// drivers get it wrong.
#include "emit/glsl/printer.h"
#include "emit/glsl/signs.h"
#include "ir/walk.h"

#include <stdexcept>

namespace gliftc::glsl {

using ir::Expr;
using ir::ExprId;
using ir::Intrinsic;
using ir::TypeId;

namespace {

TypeId type_of(const Printer& p, const Expr& expr, std::size_t operand) {
    return p.program.exprs[expr.operands[operand]].type;
}

Text call(Printer& p, const char* name, const Expr& expr) {
    return {std::string(name) + "(" + join_arguments(p, expr.operands) + ")"};
}

/// Calls a helper with every operand broadcast to the shape of the result.
Text shaped(Printer& p, Helper helper, const Expr& expr) {
    std::string text = need(p, helper, expr.type) + "(";
    for (std::size_t i = 0; i < expr.operands.size(); ++i)
        text += (i ? ", " : "") + print_as(p, expr.operands[i], expr.type);
    return {text + ")"};
}

/// GLSL has lessThan and its kin for vectors only; scalars are compared by operators.
Text compare(Printer& p, const char* name, const char* sign, Level level, const Expr& expr) {
    if (p.program.types.is_vector(expr.type)) {
        TypeId a = type_of(p, expr, 0), b = type_of(p, expr, 1);
        TypeId shape = p.program.types.is_vector(a) ? a : b;
        return {std::string(name) + "(" + print_as(p, expr.operands[0], shape) + ", " +
                print_as(p, expr.operands[1], shape) + ")"};
    }
    Level inner = static_cast<Level>(static_cast<int>(level) + 1);
    return {print(p, expr.operands[0], inner) + " " + sign + " " + print(p, expr.operands[1], inner), level};
}

/// any and all of a scalar are the scalar.
Text reduce_bools(Printer& p, const char* name, const Expr& expr) {
    return p.program.types.is_vector(type_of(p, expr, 0)) ? call(p, name, expr) : print(p, expr.operands[0]);
}

Text minimum(Printer& p, const char* name, const Expr& expr) {
    const ir::Types& types = p.program.types;
    if (types.is_vector(expr.type) && !types.is_vector(type_of(p, expr, 0)))
        return {std::string(name) + "(" + print_as(p, expr.operands[0], expr.type) + ", " +
                print_any(p, expr.operands[1]) + ")"};
    return call(p, name, expr);
}

/// `clamp` of integers where the bounds are scalar constants in order; else min and max. GLSL leaves clamp undefined if
/// the bounds are not in order, and of clamp(x, 0.0, 1.0) NVIDIA's driver (580) makes an instruction that flushes
/// subnormal numbers to zero.
Text clamp(Printer& p, const Expr& expr) {
    const Expr& low = p.program.exprs[expr.operands[1]];
    const Expr& high = p.program.exprs[expr.operands[2]];
    bool both = low.op == ir::Op::constant && high.op == ir::Op::constant;
    bool is_signed = p.program.types.is_signed(low.type);
    bool in_order =
        is_signed ? static_cast<std::int64_t>(low.bits) <= static_cast<std::int64_t>(high.bits) : low.bits <= high.bits;
    if (both && in_order && !p.program.types.is_floating(low.type)) return call(p, "clamp", expr);
    return {"min(max(" + print_any(p, expr.operands[0]) + ", " + print_any(p, expr.operands[1]) + "), " +
            print_any(p, expr.operands[2]) + ")"};
}

Text dot(Printer& p, const Expr& expr) {
    TypeId type = type_of(p, expr, 0);
    return {need(p, Helper::ordered_dot, type) + "(" + join_arguments(p, expr.operands) + ")"};
}

Text atomic(Printer& p, const char* name, const Expr& expr) {
    ir::TypeKind kind = p.program.types.kind(type_of(p, expr, 0));
    if (kind == ir::TypeKind::int64 || kind == ir::TypeKind::uint64) p.extensions.insert("GL_EXT_shader_atomic_int64");
    if (kind == ir::TypeKind::float_) p.extensions.insert("GL_EXT_shader_atomic_float");
    const ir::Op place = ir::place_of(p.program, expr.operands[0]).op;
    if (place == ir::Op::load || place == ir::Op::image_load) return {ordered_atomic(p, name, expr)};
    // Workgroup memory is ordered by barriers, so plain accesses suffice in place of atomic loads and stores.
    if (expr.intrinsic == Intrinsic::atomicLoad) return print(p, expr.operands[0]);
    if (expr.intrinsic == Intrinsic::atomicStore)
        return {print_any(p, expr.operands[0]) + " = " + print_any(p, expr.operands[1])};
    return call(p, name, expr);
}

/// Does not use GLSL's sign: NVIDIA's driver (580) fails to compile sign(x) of 64-bit integers beside other arithmetic,
/// and sign(~x) ^ y of 32-bit integers. For NaN, GLSL leaves sign undefined; the helper gives 0.
Text sign(Printer& p, const Expr& expr) {
    const ir::Types& types = p.program.types;
    const TypeId scalar = types.scalar_of(expr.type);
    if (types.is_floating(scalar) || scalar == types.int64) return shaped(p, Helper::sign_of, expr);
    const std::string x = print_any(p, expr.operands[0]);
    return {"clamp(" + x + ", -1, 1)"};
}

}  // namespace

// long: a case for each built-in function
Text print_intrinsic(Printer& p, const Expr& expr) {
    switch (expr.intrinsic) {
    case Intrinsic::abs:
        return may_be_chosen_negative_zero(p, expr.operands[0]) ? shaped(p, Helper::magnitude, expr)
                                                                : call(p, "abs", expr);
    case Intrinsic::sign: return sign(p, expr);
    case Intrinsic::floor: return call(p, "floor", expr);
    case Intrinsic::ceil: return call(p, "ceil", expr);
    case Intrinsic::round: return call(p, "roundEven", expr);
    case Intrinsic::trunc: return call(p, "trunc", expr);
    case Intrinsic::fract: return shaped(p, Helper::fraction, expr);
    case Intrinsic::min: return minimum(p, "min", expr);
    case Intrinsic::max: return minimum(p, "max", expr);
    case Intrinsic::clamp: return clamp(p, expr);
    case Intrinsic::mod: return shaped(p, Helper::modulo, expr);
    case Intrinsic::sqrt:
        return corrects_division(p, expr.type) ? shaped(p, Helper::square_root, expr) : call(p, "sqrt", expr);
    case Intrinsic::isnan: return call(p, "isnan", expr);
    case Intrinsic::isinf: return call(p, "isinf", expr);
    case Intrinsic::any: return reduce_bools(p, "any", expr);
    case Intrinsic::all: return reduce_bools(p, "all", expr);
    case Intrinsic::lessThan: return compare(p, "lessThan", "<", Level::relation, expr);
    case Intrinsic::lessThanEqual: return compare(p, "lessThanEqual", "<=", Level::relation, expr);
    case Intrinsic::greaterThan: return compare(p, "greaterThan", ">", Level::relation, expr);
    case Intrinsic::greaterThanEqual: return compare(p, "greaterThanEqual", ">=", Level::relation, expr);
    case Intrinsic::equal: return compare(p, "equal", "==", Level::equality, expr);
    case Intrinsic::notEqual: return compare(p, "notEqual", "!=", Level::equality, expr);
    case Intrinsic::step: return call(p, "step", expr);
    case Intrinsic::bitCount: return call(p, "bitCount", expr);
    case Intrinsic::findLSB: return call(p, "findLSB", expr);
    case Intrinsic::findMSB: return call(p, "findMSB", expr);
    case Intrinsic::bitfieldReverse: return call(p, "bitfieldReverse", expr);
    case Intrinsic::bitfieldExtract:
        return {need(p, Helper::extract_bits, expr.type) + "(" + join_arguments(p, expr.operands) + ")"};
    case Intrinsic::bitfieldInsert:
        return {need(p, Helper::insert_bits, expr.type) + "(" + join_arguments(p, expr.operands) + ")"};
    case Intrinsic::floatBitsToUint: return call(p, "floatBitsToUint", expr);
    case Intrinsic::floatBitsToInt: return call(p, "floatBitsToInt", expr);
    case Intrinsic::uintBitsToFloat: return call(p, "uintBitsToFloat", expr);
    case Intrinsic::intBitsToFloat: return call(p, "intBitsToFloat", expr);
    case Intrinsic::doubleBitsToUint64: return call(p, "doubleBitsToUint64", expr);
    case Intrinsic::uint64BitsToDouble: return call(p, "uint64BitsToDouble", expr);
    case Intrinsic::dot: return dot(p, expr);
    case Intrinsic::cross: return shaped(p, Helper::cross_product, expr);
    case Intrinsic::mix: return shaped(p, Helper::blend, expr);
    case Intrinsic::smoothstep: return shaped(p, Helper::smooth_step, expr);
    case Intrinsic::fma: return call(p, "fma", expr);
    case Intrinsic::transpose: return call(p, "transpose", expr);
    case Intrinsic::packHalf2x16: {
        // NVIDIA's driver (580) leaves out packHalf2x16 before unpackHalf2x16, and so the rounding.
        const TypeId pair = p.program.exprs[expr.operands[0]].type;
        return {"packFloat2x16(" + need(p, Helper::to_half, pair) + "(" + join_arguments(p, expr.operands) + "))"};
    }
    case Intrinsic::unpackHalf2x16: return call(p, "unpackHalf2x16", expr);
    case Intrinsic::packUnorm4x8:
        return {need(p, Helper::pack_unorm, {}) + "(" + join_arguments(p, expr.operands) + ")"};
    case Intrinsic::unpackUnorm4x8:
        return {need(p, Helper::unpack_unorm, expr.type) + "(" + join_arguments(p, expr.operands) + ")"};
    case Intrinsic::exp: return call(p, "exp", expr);
    case Intrinsic::exp2: return call(p, "exp2", expr);
    case Intrinsic::log: return call(p, "log", expr);
    case Intrinsic::log2: return call(p, "log2", expr);
    case Intrinsic::pow: return call(p, "pow", expr);
    case Intrinsic::sin: return call(p, "sin", expr);
    case Intrinsic::cos: return call(p, "cos", expr);
    case Intrinsic::tan: return call(p, "tan", expr);
    case Intrinsic::asin: return call(p, "asin", expr);
    case Intrinsic::acos: return call(p, "acos", expr);
    case Intrinsic::atan: return call(p, "atan", expr);
    case Intrinsic::atan2: return shaped(p, Helper::angle, expr);
    case Intrinsic::sinh: return call(p, "sinh", expr);
    case Intrinsic::cosh: return call(p, "cosh", expr);
    case Intrinsic::tanh: return call(p, "tanh", expr);
    case Intrinsic::inversesqrt: return call(p, "inversesqrt", expr);
    case Intrinsic::length: return call(p, "length", expr);
    case Intrinsic::distance: return call(p, "distance", expr);
    case Intrinsic::normalize: return call(p, "normalize", expr);
    case Intrinsic::reflect: return shaped(p, Helper::reflection, expr);
    case Intrinsic::determinant: return call(p, "determinant", expr);
    case Intrinsic::inverse: return call(p, "inverse", expr);
    case Intrinsic::dFdx: return call(p, "dFdxFine", expr);  // dFdx may be coarse
    case Intrinsic::dFdy: return call(p, "dFdyFine", expr);
    case Intrinsic::fwidth: return call(p, "fwidthFine", expr);
    case Intrinsic::subgroupAdd:
    case Intrinsic::subgroupMin:
    case Intrinsic::subgroupMax:
    case Intrinsic::subgroupMul:
    case Intrinsic::subgroupAnd:
    case Intrinsic::subgroupOr:
    case Intrinsic::subgroupXor:
    case Intrinsic::subgroupExclusiveAdd:
    case Intrinsic::subgroupExclusiveMin:
    case Intrinsic::subgroupExclusiveMax:
    case Intrinsic::subgroupInclusiveAdd:
    case Intrinsic::subgroupInclusiveMin:
    case Intrinsic::subgroupInclusiveMax:
    case Intrinsic::subgroupAll:
    case Intrinsic::subgroupAny:
    case Intrinsic::subgroupElect:
    case Intrinsic::subgroupBroadcast:
    case Intrinsic::subgroupBroadcastFirst:
    case Intrinsic::subgroupShuffle:
    case Intrinsic::subgroupShuffleXor:
    case Intrinsic::subgroupShuffleUp:
    case Intrinsic::subgroupShuffleDown:
    case Intrinsic::subgroupBallot:
    case Intrinsic::subgroupBallotCount:
    case Intrinsic::subgroupBallotExclusiveCount: return print_subgroup(p, expr);
    case Intrinsic::atomicLoad: return atomic(p, "atomicLoad", expr);
    case Intrinsic::atomicStore: return atomic(p, "atomicStore", expr);
    case Intrinsic::atomicAdd: return atomic(p, "atomicAdd", expr);
    case Intrinsic::atomicMin: return atomic(p, "atomicMin", expr);
    case Intrinsic::atomicMax: return atomic(p, "atomicMax", expr);
    case Intrinsic::atomicAnd: return atomic(p, "atomicAnd", expr);
    case Intrinsic::atomicOr: return atomic(p, "atomicOr", expr);
    case Intrinsic::atomicXor: return atomic(p, "atomicXor", expr);
    case Intrinsic::atomicExchange: return atomic(p, "atomicExchange", expr);
    case Intrinsic::atomicCompareExchange: return atomic(p, "atomicCompSwap", expr);
    }
    throw std::logic_error("emit/glsl: unknown intrinsic");
}

}  // namespace gliftc::glsl
