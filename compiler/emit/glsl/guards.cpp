// Operations whose result the language defines for all operands, but GLSL only for some. The printer adds guards (a
// max, a mask, a clamp) for the other operands; this file decides where those of divisors, shift amounts and indices
// can be left out.
//
// The meaning is the same on every target: an integer divided by zero is divided by one (INT_MIN / -1, too), shift
// amounts count modulo the width, indices are clamped to the valid range, conversions of floats to integers saturate.
#include "emit/glsl/printer.h"

#include <algorithm>

namespace gliftc::glsl {

using ir::Expr;
using ir::ExprId;
using ir::Op;

namespace {

bool depends_on_value_parameters(const ir::Program& program, ExprId id) {
    const Expr& expr = program.exprs[id];
    if (expr.op == Op::local) return true;
    for (ExprId operand : expr.operands)
        if (depends_on_value_parameters(program, operand)) return true;
    return false;
}

/// Whether a parameter depends on the state of structures alone, or is the extent of the range of Pass::address. The
/// former is not zero where it is a divisor: lower/expand/divisors.cpp makes sure of that. The latter is not zero if
/// any invocation runs.
bool is_state_of_structures(const Printer& p, std::uint32_t parameter) {
    const ir::PassParameter& param = p.pass.parameters[parameter];
    switch (param.source) {
    case ir::ParameterSource::uniform: return param.value && !depends_on_value_parameters(p.program, param.value);
    case ir::ParameterSource::size: return true;
    case ir::ParameterSource::range_size:
    case ir::ParameterSource::index:
    case ir::ParameterSource::base:
    case ir::ParameterSource::origin:
    case ir::ParameterSource::address: return false;
    }
    return false;
}

constexpr std::uint64_t most_uint = UINT32_MAX;

std::uint64_t most_of_binary(const Printer& p, const Expr& expr) {
    const std::uint64_t a = largest(p, expr.operands[0]), b = largest(p, expr.operands[1]);
    const auto unless_wrapped = [](std::uint64_t value) { return std::min(value, most_uint); };
    const Expr& right = p.program.exprs[expr.operands[1]];
    const bool is_known = right.op == Op::constant && right.bits != 0;
    switch (expr.binary) {
    case ir::BinaryOp::bit_and: return std::min(a, b);
    case ir::BinaryOp::add: return unless_wrapped(a + b);
    case ir::BinaryOp::multiply: return unless_wrapped(a * b);
    case ir::BinaryOp::divide: return is_known ? a / right.bits : most_uint;
    case ir::BinaryOp::remainder: return is_known ? std::min(a, right.bits - 1) : most_uint;
    case ir::BinaryOp::shift_right: return is_known ? a >> (right.bits & 31) : a;
    default: return most_uint;
    }
}

}  // namespace

std::uint64_t largest(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    if (expr.type != p.program.types.uint) return most_uint;
    switch (expr.op) {
    case Op::constant: return expr.bits;
    case Op::local: {
        const auto found = p.bounds.find(expr.local);
        if (found == p.bounds.end() || found->second.low < 0 || found->second.high <= 0) return most_uint;
        return std::min(static_cast<std::uint64_t>(found->second.high) - 1, most_uint);
    }
    case Op::builtin: {
        const auto& group = p.pass.group;
        const bool is_index = expr.builtin == ir::Builtin::local_index;
        return is_index ? std::uint64_t{group[0]} * group[1] * group[2] - 1 : most_uint;
    }
    case Op::select: return std::max(largest(p, expr.operands[1]), largest(p, expr.operands[2]));
    case Op::intrinsic:
        if (expr.intrinsic != ir::Intrinsic::min) return most_uint;
        return std::min(largest(p, expr.operands[0]), largest(p, expr.operands[1]));
    case Op::binary: return most_of_binary(p, expr);
    default: return most_uint;
    }
}

bool divisor_is_safe(const Printer& p, ExprId id) {
    const Expr& expr = p.program.exprs[id];
    const ir::Types& types = p.program.types;
    bool is_signed = types.is_signed(types.scalar_of(expr.type));
    switch (expr.op) {
    case Op::constant:
        return expr.bits != 0 && !(is_signed && static_cast<std::int64_t>(expr.bits) == -1) &&
               !(is_signed && static_cast<std::uint32_t>(expr.bits) == 0xffffffffu);
    case Op::construct:
        for (ExprId operand : expr.operands)
            if (!divisor_is_safe(p, operand)) return false;
        return true;
    case Op::intrinsic:
        return !is_signed && expr.intrinsic == ir::Intrinsic::max && divisor_is_safe(p, expr.operands[1]);
    case Op::local: {
        const auto found = p.bounds.find(expr.local);
        return !is_signed && found != p.bounds.end() && found->second.low > 0;
    }
    case Op::parameter: return !is_signed && is_state_of_structures(p, expr.slot);
    case Op::swizzle:
    case Op::field: return divisor_is_safe(p, expr.operands[0]);
    default: return false;
    }
}

bool shift_is_safe(const Printer& p, ExprId id, std::uint32_t width) {
    const Expr& expr = p.program.exprs[id];
    if (expr.op == Op::constant) return expr.bits < width;
    if (expr.op != Op::construct) return false;
    for (ExprId operand : expr.operands)
        if (!shift_is_safe(p, operand, width)) return false;
    return true;
}

std::string guarded_index(Printer& p, ExprId id, std::uint32_t count) {
    const Expr& expr = p.program.exprs[id];
    if (expr.op == Op::constant && expr.bits < count) return print_any(p, id);
    if (largest(p, id) < count) return print_any(p, id);
    if (expr.op == Op::local) {
        auto found = p.bounds.find(expr.local);
        if (found != p.bounds.end() && found->second.low >= 0 && found->second.high <= static_cast<std::int64_t>(count))
            return print_any(p, id);
    }
    std::string last = std::to_string(count - 1);
    if (!p.program.types.is_signed(expr.type)) return "min(" + print_any(p, id) + ", " + last + "u)";
    return "clamp(" + print_any(p, id) + ", 0, " + last + ")";
}

}  // namespace gliftc::glsl
