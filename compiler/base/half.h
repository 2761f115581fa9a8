// Rounding to 16-bit floats, without _Float16, which older versions of clang have only for targets with native support.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace gliftc {

/// The 16-bit float nearest to the number, ties to even; infinity, with the number's sign, if rounding gives more than
/// the largest half, 65504.
inline double round_to_half(double number) {
    if (number == 0 || !std::isfinite(number)) return number;
    constexpr int smallest_exponent = -14, fraction_bits = 10;
    const int exponent = std::max(std::ilogb(number), smallest_exponent);
    const double rounded =
        std::ldexp(std::nearbyint(std::ldexp(number, fraction_bits - exponent)), exponent - fraction_bits);
    constexpr double largest = 65504;
    return std::abs(rounded) > largest ? std::copysign(std::numeric_limits<double>::infinity(), number) : rounded;
}

}  // namespace gliftc
