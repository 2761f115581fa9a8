#version 460
// One arithmetic operation on every element, for comparison with the CPU: see probe_exact.cpp.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(constant_id = 0) const uint operation = 0;

layout(push_constant) uniform Parameters { uint count; };
layout(scalar, set = 0, binding = 0) readonly buffer A { uint a_bits[]; };
layout(scalar, set = 0, binding = 1) readonly buffer B { uint b_bits[]; };
layout(scalar, set = 0, binding = 2) readonly buffer C { uint c_bits[]; };
layout(scalar, set = 0, binding = 3) writeonly buffer R { uint r_bits[]; };

bool is_ordinary(float x) {   // finite, not zero
    uint magnitude = floatBitsToUint(x) & 0x7fffffffu;
    return magnitude != 0u && magnitude < 0x7f800000u;
}

// x = mantissa * 2^exponent, 1 <= |mantissa| < 2; x is ordinary.
float split(float x, out int exponent) {
    uint bits = floatBitsToUint(x), magnitude = bits & 0x7fffffffu;
    int shift = magnitude < 0x00800000u ? 23 - findMSB(magnitude) : 0;
    exponent = int(magnitude >> 23) - 127;
    if (shift > 0) exponent = -126 - shift;
    uint fraction = (magnitude << uint(shift)) & 0x007fffffu;
    return uintBitsToFloat((bits & 0x80000000u) | 0x3f800000u | fraction);
}

// Correctly rounded mantissas a / b of 1 <= |a|, |b| < 2 (Markstein).
float divide_mantissas(float a, float b) {
    float y = 1.0 / b;
    y = fma(fma(-b, y, 1.0), y, y);
    y = fma(fma(-b, y, 1.0), y, y);
    float q = a * y;
    q = fma(fma(-b, q, a), y, q);
    return fma(fma(-b, q, a), y, q);
}

// |a| / |b| * 2^exponent for results below the normal numbers: restoring division, to half to even.
float divide_subnormal(uint sign, float a, float b, int exponent) {
    uint numerator = (floatBitsToUint(a) & 0x007fffffu) | 0x00800000u, divisor = (floatBitsToUint(b) & 0x007fffffu) | 0x00800000u;
    int bits = exponent + 149;           // of the quotient above its unit, 2^-149
    if (bits < -1) return uintBitsToFloat(sign);
    uint quotient = 0u, rest = numerator;
    for (int i = 0; i < 25; ++i) {
        if (i > bits + 1) break;
        quotient <<= 1;
        if (rest >= divisor) {
            rest -= divisor;
            quotient |= 1u;
        }
        rest <<= 1;
    }
    uint half_bit = quotient & 1u;       // one bit more than fits
    quotient >>= 1;
    bool round_up = half_bit == 1u && (rest != 0u || (quotient & 1u) == 1u);
    return uintBitsToFloat(sign | (quotient + uint(round_up)));
}

float exact_divide(float a, float b) {
    if (!is_ordinary(a) || !is_ordinary(b)) {
        uint sign = (floatBitsToUint(a) ^ floatBitsToUint(b)) & 0x80000000u;
        uint x = floatBitsToUint(a) & 0x7fffffffu, y = floatBitsToUint(b) & 0x7fffffffu;
        if (x > 0x7f800000u || y > 0x7f800000u || (x == y)) return uintBitsToFloat(0x7fc00000u);   // x == y: 0 / 0, inf / inf
        return uintBitsToFloat(sign | (x == 0u || y == 0x7f800000u ? 0u : 0x7f800000u));
    }
    int a_exponent, b_exponent;
    float x = split(a, a_exponent), y = split(b, b_exponent);
    int exponent = a_exponent - b_exponent;
    float q = divide_mantissas(x, y);
    uint bits = floatBitsToUint(q), sign = bits & 0x80000000u;
    int result = int((bits >> 23) & 0xffu) + exponent;
    if (result >= 255) return uintBitsToFloat(sign | 0x7f800000u);
    if (result >= 1) return uintBitsToFloat((bits & 0x807fffffu) | (uint(result) << 23));
    return divide_subnormal(sign, x, y, exponent);
}

// The same with the device's own quotient where neither side is extreme: what generated code would use.
float quick_divide(float a, float b) {
    uint x = (floatBitsToUint(a) >> 23) & 0xffu, y = (floatBitsToUint(b) >> 23) & 0xffu;
    if (x - 64u >= 126u || y - 64u >= 126u) return exact_divide(a, b);
    float q = a / b, r = 1.0 / b;
    r = fma(fma(-b, r, 1.0), r, r);
    q = fma(fma(-b, q, a), r, q);
    return fma(fma(-b, q, a), r, q);
}

float exact_sqrt(float x) {
    uint bits = floatBitsToUint(x);
    if ((bits & 0x7fffffffu) == 0u || bits == 0x7f800000u) return x;
    if (bits > 0x7f800000u) return uintBitsToFloat(0x7fc00000u);   // negative, or not a number
    int exponent;
    float m = split(x, exponent);
    int odd = exponent & 1;
    if (odd == 1) m *= 2.0;
    float y = inversesqrt(m), g = m * y, h = 0.5 * y;
    float r = fma(-h, g, 0.5);
    g = fma(g, r, g);
    h = fma(h, r, h);
    r = fma(-h, g, 0.5);
    g = fma(g, r, g);
    h = fma(h, r, h);
    g = fma(fma(-g, g, m), h, g);
    return uintBitsToFloat(floatBitsToUint(g) + uint((exponent - odd) / 2 << 23));
}

int saturated_int(float x) {
    if (x >= -2147483648.0) return x < 2147483648.0 ? int(x) : 2147483647;
    return x < -2147483648.0 ? int(0x80000000u) : 0;
}

uint saturated_uint(float x) {
    if (x > 0.0) return x < 4294967296.0 ? uint(x) : 4294967295u;
    return 0u;
}

uint result_of(uint i) {
    uint x = a_bits[i], y = b_bits[i], z = c_bits[i];
    float a = uintBitsToFloat(x), b = uintBitsToFloat(y), c = uintBitsToFloat(z);
    switch (operation) {
    case 0: return floatBitsToUint(a + b);
    case 1: return floatBitsToUint(a - b);
    case 2: return floatBitsToUint(a * b);
    case 3: return floatBitsToUint(a * b + c);
    case 4: return floatBitsToUint(fma(a, b, c));
    case 5: return floatBitsToUint(a / b);
    case 6: return floatBitsToUint(sqrt(a));
    case 7: return floatBitsToUint(exact_divide(a, b));
    case 8: return floatBitsToUint(quick_divide(a, b));
    case 9: return floatBitsToUint(exact_sqrt(a));
    case 10: return floatBitsToUint(float(double(a) / double(b)));
    case 11: return floatBitsToUint(float(sqrt(double(a))));
    case 12: return floatBitsToUint(min(a, b));
    case 13: return floatBitsToUint(max(a, b));
    case 14: return floatBitsToUint(min(max(a, b), c));
    case 15: return uint(int(a));
    case 16: return uint(a);
    case 17: return uint(saturated_int(a));
    case 18: return saturated_uint(a);
    case 19: return floatBitsToUint(float(int(x)));
    case 20: return floatBitsToUint(float(x));
    case 21: return x / y;
    case 22: return x % y;
    case 23: return uint(int(x) / int(y));
    case 24: return x / max(y, 1u);
    case 25: return x << y;
    case 26: return x >> y;
    case 27: return uint(int(x) >> int(y));
    case 28: return x << (y & 31u);
    case 29: return floatBitsToUint(roundEven(a));
    case 30: return floatBitsToUint(floor(a));
    case 31: return floatBitsToUint(trunc(a));
    case 32: return floatBitsToUint(a - floor(a));
    case 33: return packHalf2x16(vec2(a, b));
    case 34: return (a < b ? 1u : 0u) | (a == b ? 2u : 0u) | (a != b ? 4u : 0u) | (isnan(a) ? 8u : 0u) | (isinf(a) ? 16u : 0u);
    case 35: return floatBitsToUint(a / 255.0);
    case 36: return floatBitsToUint(vec3(a, b, c).y / b + (-a));
    }
    return 0u;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    r_bits[i] = result_of(i);
}
