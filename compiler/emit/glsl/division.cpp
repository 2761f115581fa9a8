// Division and square root that come out correctly rounded on devices whose own are not.
//
// A device's quotients may be 2.5 units in the last place off, and its roots are only as exact as 1 / inversesqrt
// (Vulkan, "Precision of core SPIR-V instructions"). Markstein's corrections, made with fused multiply-adds, get the
// correctly rounded result from an approximation of the reciprocal. Operands of roots, and quotients' operands far from
// 1, are scaled to near 1 first, so that nothing overflows or is flushed to zero. Quotients and roots of halves are
// computed as floats and rounded to halves: a float has more than twice the digits, so that rounding twice gives the
// same as rounding once. tests/device/accuracy compares the results with the host device's. Where the device's own
// results are correctly rounded (lavapipe, whose fma is not fused), the runtime says so by specialisation constant 100.
// By a constant one correction is enough (Brisebarre, Muller and Raina, Accelerating Correctly Rounded Floating-Point
// Division When the Divisor Is Known in Advance, IEEE Transactions on Computers 53, 2004).
#include "emit/glsl/printer.h"

#include <bit>
#include <cmath>

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

/// The quotient of ordinary operands: the end of divide and quick_divide. Not a function: drivers do not inline all
/// calls.
constexpr const char* ordinary_quotient_text = R"(    float r = 1.0 / b;
    r = rounded_reciprocal(b, fma(fma(-b, r, 1.0), r, r));
    float q = a * r;
    q = fma(fma(-b, q, a), r, q);
    return fma(fma(-b, q, a), r, q);
}
)";

constexpr const char* quotient_text =
    R"(// r is 1 / b rounded, unless b's mantissa is all ones: then r is a power of two, one unit in the last place too small.
float rounded_reciprocal(float b, float r) {
    return uintBitsToFloat(floatBitsToUint(r) | uint((floatBitsToUint(b) & 0x007fffffu) == 0x007fffffu));
}

// The quotient's magnitude where that is subnormal, rounded once, ties to even. q: the quotient times a power of two,
// rounded. shift: by how many bits q's mantissa is too long. rest: positive if the exact quotient is larger than q,
// negative if it is smaller.
uint subnormal_quotient(float q, int shift, float rest) {
    uint mantissa = (floatBitsToUint(q) & 0x007fffffu) | 0x00800000u, bits = uint(min(shift, 25));
    uint whole = mantissa >> bits, lost = mantissa - (whole << bits), half_unit = 1u << (bits - 1u);
    bool up = lost > half_unit || (lost == half_unit && (rest > 0.0 || (rest == 0.0 && (whole & 1u) == 1u)));
    return whole + uint(up);
}

float scaled_quotient(float a, float b) {
    uint x = floatBitsToUint(a) & 0x7fffffffu, y = floatBitsToUint(b) & 0x7fffffffu, magnitude;
    if (x > 0x7f800000u || y > 0x7f800000u) {
        magnitude = 0x7fc00000u;
    } else if (x == 0u || y == 0u || x == 0x7f800000u || y == 0x7f800000u) {
        magnitude = x == y ? 0x7fc00000u : x == 0u || y == 0x7f800000u ? 0u : 0x7f800000u;
    } else {
        int x_exponent, y_exponent;
        float m = split(uintBitsToFloat(x), x_exponent), n = split(uintBitsToFloat(y), y_exponent), r = 1.0 / n;
        r = fma(fma(-n, r, 1.0), r, r);
        r = rounded_reciprocal(n, fma(fma(-n, r, 1.0), r, r));
        float q = m * r;
        q = fma(fma(-n, q, m), r, q);
        q = fma(fma(-n, q, m), r, q);
        int biased = int(floatBitsToUint(q) >> 23) + x_exponent - y_exponent;
        if (biased >= 255) {
            magnitude = 0x7f800000u;
        } else if (biased >= 1) {
            magnitude = (floatBitsToUint(q) & 0x007fffffu) | (uint(biased) << 23);
        } else {
            magnitude = subnormal_quotient(q, 1 - biased, fma(-n, q, m));
        }
    }
    return uintBitsToFloat(((floatBitsToUint(a) ^ floatBitsToUint(b)) & 0x80000000u) | magnitude);
}

// Whether a and b are between 2^-63 and 2^63, or a is zero. Without && and ||, which are branches.
bool is_ordinary(float a, float b) {
    vec2 sizes = abs(vec2(floatBitsToUint(a) == 0u ? 1.0 : a, b));
    vec2 low = vec2(1.0842021724855044e-19), high = vec2(9223372036854775808.0);
    return all(bvec4(greaterThanEqual(sizes, low), lessThan(sizes, high)));
}

float divide(float a, float b) {
    if (exact_division) return a / b;
    if (!is_ordinary(a, b)) return scaled_quotient(a, b);
)";

constexpr const char* quotient_by_constant_text = R"(bool is_ordinary_dividend(float a) {
    float x = floatBitsToUint(a) == 0u ? 1.0 : abs(a);
    return all(bvec2(x >= 1.0842021724855044e-19, x < 9223372036854775808.0));
}

// r is 1 / b rounded; b is between 2^-62 and 2^62.
float divide_by(float a, float b, float r) {
    if (exact_division) return a / b;
    if (!is_ordinary_dividend(a)) return scaled_quotient(a, b);
    float q = a * r;
    return fma(fma(-b, q, a), r, q);
}
)";

constexpr const char* quick_quotient_text = R"(// Whether the operands of all quick quotients so far were ordinary.
bool has_usual_quotients = true;

float quick_divide(float a, float b) {
    if (exact_division) return a / b;
    has_usual_quotients = all(bvec2(has_usual_quotients, is_ordinary(a, b)));
)";

constexpr const char* quick_quotient_by_constant_text = R"(float quick_divide_by(float a, float b, float r) {
    if (exact_division) return a / b;
    has_usual_quotients = all(bvec2(has_usual_quotients, is_ordinary_dividend(a)));
    float q = a * r;
    return fma(fma(-b, q, a), r, q);
}
)";

constexpr const char* root_text = R"(float square_root(float x) {
    float root = sqrt(x);
    if (!exact_division) {
        uint bits = floatBitsToUint(x);
        if (bits > 0x80000000u) {
            root = uintBitsToFloat(0x7fc00000u);
        } else if (bits == 0u || bits == 0x80000000u || bits >= 0x7f800000u) {
            root = x;
        } else {
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
            root = uintBitsToFloat(floatBitsToUint(g) + (uint((exponent - odd) / 2) << 23));
        }
    }
    return root;
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

/// A function of each component of a, of the constant b and its reciprocal r.
std::string quotients_by_constant(const std::string& name, const std::string& type, std::uint32_t count) {
    std::string text = type + " " + name + "(" + type + " a, float b, float r) {\n    return " + type + "(";
    for (std::uint32_t i = 0; i < count; ++i) text += (i ? ", " : "") + name + "(a." + "xyzw"[i] + ", b, r)";
    return text + ");\n}\n";
}

}  // namespace

std::string division_definition(Printer& p, const HelperUse& use) {
    const bool half = use.a == p.program.types.half;
    switch (use.helper) {
    case Helper::split_float: return common;
    case Helper::divide_by:
    case Helper::quick_divide_by: {
        const bool is_quick = use.helper == Helper::quick_divide_by;
        const std::uint32_t count = p.program.types.components(use.a);
        if (count == 1) return is_quick ? quick_quotient_by_constant_text : quotient_by_constant_text;
        return quotients_by_constant(is_quick ? "quick_divide_by" : "divide_by", type_text(p, use.a), count);
    }
    case Helper::quick_divide: return std::string(quick_quotient_text) + ordinary_quotient_text;
    case Helper::divide: return half ? half_quotient_text : std::string(quotient_text) + ordinary_quotient_text;
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

/// Whether the expression is a scalar constant whose rounded reciprocal is enough for correct quotients
/// (quotient_by_constant_text).
bool is_ordinary_constant(const Printer& p, ir::ExprId id) {
    const ir::Expr& expr = p.program.exprs[id];
    if (expr.op != ir::Op::constant || expr.type != p.program.types.float_) return false;
    const float value = std::abs(static_cast<float>(expr.number));
    const std::uint32_t mantissa = std::bit_cast<std::uint32_t>(value) & 0x007fffffu;
    return value >= 0x1p-62f && value <= 0x1p62f && mantissa != 0x007fffffu;
}

bool corrects_division(const Printer& p, ir::TypeId type) {
    const ir::Types& types = p.program.types;
    const ir::TypeId scalar = types.scalar_of(type);
    return p.options.rounding == Rounding::correct && (scalar == types.float_ || scalar == types.half);
}

bool is_quick_quotient(const Printer& p, const ir::Expr& expr) {
    return expr.op == ir::Op::binary && expr.binary == ir::BinaryOp::divide &&
           p.program.types.scalar_of(expr.type) == p.program.types.float_ && !p.program.types.is_matrix(expr.type) &&
           corrects_division(p, expr.type) && !is_power_of_two(p, expr.operands[1]);
}

Text print_quotient(Printer& p, const ir::Expr& expr) {
    const ir::ExprId a = expr.operands[0], b = expr.operands[1];
    const bool is_quick = p.has_quick_quotients && is_quick_quotient(p, expr);
    if (is_ordinary_constant(p, b)) {
        const float r = 1.0f / static_cast<float>(p.program.exprs[b].number);
        const std::string name = need(p, is_quick ? Helper::quick_divide_by : Helper::divide_by, expr.type);
        return {name + "(" + print_as(p, a, expr.type) + ", " + print_any(p, b) + ", " +
                literal(p, p.program.types.float_, 0, r) + ")"};
    }
    const std::string name = need(p, is_quick ? Helper::quick_divide : Helper::divide, expr.type);
    return {name + "(" + print_as(p, a, expr.type) + ", " + print_as(p, b, expr.type) + ")"};
}

std::string quotient_of(Printer& p, ir::TypeId type, const std::string& a, const std::string& b) {
    if (!corrects_division(p, type)) return a + " / " + b;
    return need(p, Helper::divide, type) + "(" + a + ", " + b + ")";
}

}  // namespace gliftc::glsl
