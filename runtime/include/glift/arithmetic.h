// Arithmetic and conversions of the language. Results are also defined where C++ leaves them undefined: for example for
// a divisor of 0, shifts beyond the width, and floating values that do not fit an integer type.
#pragma once

#include <glift/half.h>

#include <cstdint>
#include <limits>
#include <type_traits>

namespace glift {

template <class T> inline constexpr bool is_integer = std::is_integral_v<T> && !std::is_same_v<T, bool>;

template <class T> inline constexpr bool is_floating = std::is_floating_point_v<T> || std::is_same_v<T, half>;

/// The divisor that is used for a / b: 1 in place of 0, and in place of -1 where the quotient would overflow.
template <class T> constexpr T divisor(T a, T b) {
    if constexpr (std::is_signed_v<T>) return b == 0 || (b == -1 && a == std::numeric_limits<T>::min()) ? T{1} : b;
    else return b > 0 ? b : T{1};
}

/// a - b. Generated code calls this where a is a constant floating zero: GCC 12 and 13 turn the expression
/// 0.0f - float(i) into -float(i), which is -0 for i = 0.
template <class T> constexpr T subtract(T a, T b) { return static_cast<T>(a - b); }

/// a / b. For integers, the result is a where b is 0 or the quotient would overflow.
template <class T> constexpr T divide(T a, T b) {
    if constexpr (std::is_integral_v<T>) return static_cast<T>(a / divisor(a, b));
    else return a / b;
}

/// a % b, with the sign of a; 0 where b is 0.
template <class T> constexpr T remainder(T a, T b) { return static_cast<T>(a % divisor(a, b)); }

/// Shifts take their amount modulo the width of a in bits. A right shift of a signed a keeps the sign.
template <class T, class U> constexpr T shift_left(T a, U amount) {
    using V = std::make_unsigned_t<T>;
    return static_cast<T>(static_cast<V>(a) << (static_cast<V>(amount) & (sizeof(T) * 8 - 1)));
}
template <class T, class U> constexpr T shift_right(T a, U amount) {
    return static_cast<T>(a >> (static_cast<std::make_unsigned_t<T>>(amount) & (sizeof(T) * 8 - 1)));
}

/// Converts a value to another scalar type. A floating value becomes an integer by truncation: a value that does not
/// fit becomes the nearest integer that does, NaN becomes zero. An integer becomes a narrower one by dropping its high
/// bits.
template <class T, class U> constexpr T convert(U value) {
    if constexpr (std::is_same_v<U, half> && !std::is_same_v<T, half>) {
        return convert<T>(static_cast<float>(value));
    } else if constexpr (std::is_same_v<T, half> && std::is_same_v<U, double>) {
        return half(value);
    } else if constexpr (std::is_same_v<T, half>) {
        return half(static_cast<float>(value));
    } else if constexpr (std::is_same_v<T, bool>) {
        return value != U{0};
    } else if constexpr (std::is_floating_point_v<U> && is_integer<T>) {
        if (!(value == value)) return 0;
        constexpr U low = static_cast<U>(std::numeric_limits<T>::min());
        constexpr U high = static_cast<U>(T{1} << (std::numeric_limits<T>::digits - 1)) * U{2};  // one past the largest
        if (value <= low) return std::numeric_limits<T>::min();
        if (value >= high) return std::numeric_limits<T>::max();
        return static_cast<T>(value);
    } else {
        return static_cast<T>(value);
    }
}

}  // namespace glift
