// The 16-bit float: arithmetic is computed in float, and its result rounded to the nearest half, ties to even. Also the
// type of bools in memory.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>

namespace glift {

namespace detail {

/// The half nearest to `value`, ties to even; overflow gives infinity, NaNs stay NaNs.
constexpr std::uint16_t half_bits(float value) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t sign = (bits >> 16) & 0x8000u;
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    if (magnitude > 0x7f800000u) return static_cast<std::uint16_t>(sign | 0x7e00u);
    if (magnitude >= 0x47800000u) return static_cast<std::uint16_t>(sign | 0x7c00u);
    if (magnitude >= 0x38800000u) {  // normal: rounding may carry into the exponent, up to infinity
        const std::uint32_t odd = (magnitude >> 13) & 1u;
        return static_cast<std::uint16_t>(sign | ((magnitude - 0x38000000u + 0xfffu + odd) >> 13));
    }
    if (magnitude < 0x33000000u) return static_cast<std::uint16_t>(sign);  // below half of the smallest subnormal
    const std::uint32_t shift = 126u - (magnitude >> 23);
    const std::uint32_t mantissa = (magnitude & 0x7fffffu) | 0x800000u;
    const std::uint32_t rest = mantissa & ((1u << shift) - 1u), middle = 1u << (shift - 1u);
    std::uint32_t result = mantissa >> shift;
    if (rest > middle || (rest == middle && (result & 1u))) ++result;
    return static_cast<std::uint16_t>(sign | result);
}

/// `value` rounded to odd: the float that equals it or, if there is none, that one of the two floats around it whose
/// last mantissa bit is 1. Rounded to a half, the result gives the same half as `value` does. Values within 1e-9 of 0,
/// which become zero as halves, are rounded to the nearest float instead.
constexpr float float_rounded_to_odd(double value) {
    const auto nearest = static_cast<float>(value);
    const double rest = value - static_cast<double>(nearest);
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(nearest);
    // Values this small become zero as halves, whatever their last bit is. A NaN or an infinite value is kept, since
    // its rest is a NaN.
    const bool is_small = nearest < 1e-9f && nearest > -1e-9f, is_inexact = rest < 0 || rest > 0;
    if (is_small || !is_inexact || (bits & 1u)) return nearest;
    return std::bit_cast<float>((rest > 0) == (nearest > 0) ? bits + 1u : bits - 1u);
}

/// The float that a half stands for; exact.
constexpr float half_value(std::uint16_t half) {
    const std::uint32_t sign = (half & 0x8000u) << 16;
    const std::uint32_t exponent = (half >> 10) & 31u, mantissa = half & 0x3ffu;
    if (exponent == 31) return std::bit_cast<float>(sign | 0x7f800000u | (mantissa << 13));
    if (exponent != 0) return std::bit_cast<float>(sign | ((exponent + 112u) << 23) | (mantissa << 13));
    const float magnitude = static_cast<float>(mantissa) * 0x1p-24f;
    return sign ? -magnitude : magnitude;
}

}  // namespace detail

struct half {
    std::uint16_t bits = 0;

    constexpr half() = default;
    constexpr half(float value) : bits(detail::half_bits(value)) {}
    /// Rounds once. A template, since a second function would make conversions of integers ambiguous.
    template <std::same_as<double> Double> constexpr half(Double value) : half(detail::float_rounded_to_odd(value)) {}
    constexpr operator float() const { return detail::half_value(bits); }

    constexpr half& operator+=(half b) { return *this = *this + b; }
    constexpr half& operator-=(half b) { return *this = *this - b; }
    constexpr half& operator*=(half b) { return *this = *this * b; }
    constexpr half& operator/=(half b) { return *this = *this / b; }

    // Rounding a float result to half gives the correctly rounded half result: float has more than twice the bits.
    friend constexpr half operator+(half a, half b) { return {static_cast<float>(a) + static_cast<float>(b)}; }
    friend constexpr half operator-(half a, half b) { return {static_cast<float>(a) - static_cast<float>(b)}; }
    friend constexpr half operator*(half a, half b) { return {static_cast<float>(a) * static_cast<float>(b)}; }
    friend constexpr half operator/(half a, half b) { return {static_cast<float>(a) / static_cast<float>(b)}; }
    friend constexpr half operator-(half a) { return {-static_cast<float>(a)}; }
    friend constexpr bool operator==(half a, half b) { return static_cast<float>(a) == static_cast<float>(b); }
    friend constexpr bool operator<(half a, half b) { return static_cast<float>(a) < static_cast<float>(b); }
    friend constexpr bool operator>(half a, half b) { return b < a; }
    friend constexpr bool operator<=(half a, half b) { return static_cast<float>(a) <= static_cast<float>(b); }
    friend constexpr bool operator>=(half a, half b) { return b <= a; }
};

/// A bool as memory stores it: four bytes, zero or one.
struct Bool {
    std::uint32_t bits = 0;

    constexpr Bool() = default;
    constexpr Bool(bool value) : bits(value) {}
    constexpr operator bool() const { return bits != 0; }
};

}  // namespace glift
