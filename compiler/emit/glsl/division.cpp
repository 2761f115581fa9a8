// Division and square root that come out correctly rounded on devices whose own are not.
//
// A device's quotients may be 2.5 units in the last place off, and its roots are only as exact as 1 / inversesqrt
// (Vulkan, "Precision of core SPIR-V instructions"). Markstein's corrections, made with fused multiply-adds, get the
// correctly rounded result from an approximation. Operands of roots, and quotients' operands far from 1, are scaled
// to near 1 first, so that nothing overflows or is flushed to zero. Quotients and roots of halves are computed as
// floats and rounded to halves: a float has more than twice the digits, so that rounding twice gives the same as
// rounding once. tests/device/accuracy compares the results with the host device's. Where the device's own results are
// correctly rounded (lavapipe, whose fma is not fused), the runtime says so by specialisation constant 100.
#include "emit/glsl/printer.h"

#include <bit>

namespace gliftc::glsl {

namespace {

constexpr const char* common =
    R"(layout(constant_id = 100) const bool exact_division = true;   // the device rounds / and sqrt correctly

// The mantissa of x, 1 to 2 and with its sign; x is finite and not zero.
float split(float x, out int exponent) {
    uint bits = floatBitsToUint(x), magnitude = bits & 0x7fffffffu;
    int shift = magnitude < 0x00800000u ? 23 - findMSB(magnitude) : 0;
    exponent = shift > 0 ? -126 - shift : int(magnitude >> 23) - 127;
    return uintBitsToFloat((bits & 0x80000000u) | 0x3f800000u | ((magnitude << uint(shift)) & 0x007fffffu));
}

)";

constexpr const char* quotient_text =
    R"(// |a / b| * 2^exponent where that is subnormal: divided bit by bit, rounded to the nearest, ties to even.
float subnormal_quotient(uint sign, float a, float b, int exponent) {
    uint rest = (floatBitsToUint(a) & 0x007fffffu) | 0x00800000u, divisor = (floatBitsToUint(b) & 0x007fffffu) | 0x00800000u;
    int bits = exponent + 149;
    if (bits < -1) return uintBitsToFloat(sign);
    uint quotient = 0u;
    for (int i = 0; i < 25 && i <= bits + 1; ++i) {
        bool fits = rest >= divisor;
        quotient = (quotient << 1) | uint(fits);
        rest = (fits ? rest - divisor : rest) << 1;
    }
    uint whole = quotient >> 1;
    bool up = (quotient & 1u) == 1u && (rest != 0u || (whole & 1u) == 1u);
    return uintBitsToFloat(sign | (whole + uint(up)));
}

float scaled_quotient(float a, float b) {
    uint x = floatBitsToUint(a) & 0x7fffffffu, y = floatBitsToUint(b) & 0x7fffffffu;
    uint sign = (floatBitsToUint(a) ^ floatBitsToUint(b)) & 0x80000000u;
    if (x > 0x7f800000u || y > 0x7f800000u) return uintBitsToFloat(0x7fc00000u);
    if (x == 0u || y == 0u || x == 0x7f800000u || y == 0x7f800000u) {
        if (x == y) return uintBitsToFloat(0x7fc00000u);
        return uintBitsToFloat(sign | (x == 0u || y == 0x7f800000u ? 0u : 0x7f800000u));
    }
    int a_exponent, b_exponent;
    float m = split(a, a_exponent), n = split(b, b_exponent), r = 1.0 / n;
    r = fma(fma(-n, r, 1.0), r, r);
    r = fma(fma(-n, r, 1.0), r, r);
    float q = m * r;
    q = fma(fma(-n, q, m), r, q);
    q = fma(fma(-n, q, m), r, q);
    int exponent = a_exponent - b_exponent, biased = int((floatBitsToUint(q) >> 23) & 0xffu) + exponent;
    if (biased >= 255) return uintBitsToFloat(sign | 0x7f800000u);
    if (biased >= 1) return uintBitsToFloat((floatBitsToUint(q) & 0x807fffffu) | (uint(biased) << 23));
    return subnormal_quotient(sign, m, n, exponent);
}

float divide(float a, float b) {
    if (exact_division) return a / b;
    uint x = (floatBitsToUint(a) >> 23) & 0xffu, y = (floatBitsToUint(b) >> 23) & 0xffu;
    if (x - 64u >= 126u || y - 64u >= 126u) return scaled_quotient(a, b);
    float q = a / b, r = 1.0 / b;
    r = fma(fma(-b, r, 1.0), r, r);
    q = fma(fma(-b, q, a), r, q);
    return fma(fma(-b, q, a), r, q);
}
)";

constexpr const char* root_text = R"(float square_root(float x) {
    if (exact_division) return sqrt(x);
    uint bits = floatBitsToUint(x);
    if ((bits & 0x7fffffffu) == 0u || bits == 0x7f800000u) return x;
    if (bits > 0x7f800000u) return uintBitsToFloat(0x7fc00000u);
    int exponent;
    float m = split(x, exponent);
    int odd = exponent & 1;
    if (odd == 1) m *= 2.0;
    float y = inversesqrt(m), g = m * y, h = 0.5 * y;
    for (int i = 0; i < 2; ++i) {
        float r = fma(-h, g, 0.5);
        g = fma(g, r, g);
        h = fma(h, r, h);
    }
    g = fma(fma(-g, g, m), h, g);
    return uintBitsToFloat(floatBitsToUint(g) + (uint((exponent - odd) / 2) << 23));
}
)";

constexpr const char* half_quotient_text = R"(float16_t divide(float16_t a, float16_t b) {
    return exact_division ? a / b : to_half(divide(float(a), float(b)));
}
)";

constexpr const char* half_root_text = R"(float16_t square_root(float16_t x) {
    return exact_division ? sqrt(x) : to_half(square_root(float(x)));
}
)";

}  // namespace

std::string division_definition(const Printer& p, const HelperUse& use) {
    const bool half = use.a == p.program.types.half;
    switch (use.helper) {
    case Helper::split_float: return common;
    case Helper::divide: return half ? half_quotient_text : quotient_text;
    default: return half ? half_root_text : root_text;
    }
}

bool is_power_of_two(const Printer& p, ir::ExprId id) {
    const ir::Expr& expr = p.program.exprs[id];
    if (expr.op == ir::Op::construct) {
        for (ir::ExprId operand : expr.operands)
            if (!is_power_of_two(p, operand)) return false;
        return true;
    }
    if (expr.op != ir::Op::constant) return false;
    if (p.program.types.is_integer(p.program.types.scalar_of(expr.type))) return std::has_single_bit(expr.bits);
    const bool half = p.program.types.scalar_of(expr.type) == p.program.types.half;
    const double magnitude = expr.number < 0 ? -expr.number : expr.number, largest = half ? 0x1p14 : 0x1p60;
    for (double power = 1 / largest; power <= largest; power *= 2)
        if (magnitude == power) return true;
    return false;
}

bool corrects_division(const Printer& p, ir::TypeId type) {
    const ir::Types& types = p.program.types;
    const ir::TypeId scalar = types.scalar_of(type);
    return p.options.rounding == Rounding::correct && (scalar == types.float_ || scalar == types.half);
}

std::string quotient_of(Printer& p, ir::TypeId type, const std::string& a, const std::string& b) {
    if (!corrects_division(p, type)) return a + " / " + b;
    return need(p, Helper::divide, type) + "(" + a + ", " + b + ")";
}

}  // namespace gliftc::glsl
