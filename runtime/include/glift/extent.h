// Sizes of memories are computed in 64 bits, saturating at 2^64 - 1, which is more than any device has.
#pragma once

#include <glift/api.h>
#include <glift/vector.h>

#include <cstdint>

namespace glift {

constexpr std::uint64_t saturated_sum(std::uint64_t a, std::uint64_t b) {
    return a > UINT64_MAX - b ? UINT64_MAX : a + b;
}
constexpr std::uint64_t saturated_product(std::uint64_t a, std::uint64_t b) {
    return b != 0 && a > UINT64_MAX / b ? UINT64_MAX : a * b;
}
constexpr std::uint64_t saturated_shift(std::uint64_t a, std::uint64_t amount) {
    if (a == 0) return 0;
    return amount >= 64 || a > UINT64_MAX >> amount ? UINT64_MAX : a << amount;
}

// The same for vectors, component by component; one operand of a sum or a product may be a scalar.
template <unsigned N> using exact_vec = vec<std::uint64_t, N>;
#define GLIFT_SATURATED(operation)                                                                                     \
    template <unsigned N> constexpr exact_vec<N> operation(const exact_vec<N>& a, const exact_vec<N>& b) {             \
        return detail::map([](std::uint64_t x, std::uint64_t y) { return operation(x, y); }, a, b);                    \
    }                                                                                                                  \
    template <unsigned N> constexpr exact_vec<N> operation(const exact_vec<N>& a, std::uint64_t b) {                   \
        return operation(a, exact_vec<N>(b));                                                                          \
    }                                                                                                                  \
    template <unsigned N> constexpr exact_vec<N> operation(std::uint64_t a, const exact_vec<N>& b) {                   \
        return operation(exact_vec<N>(a), b);                                                                          \
    }
GLIFT_SATURATED(saturated_sum)
GLIFT_SATURATED(saturated_product)
#undef GLIFT_SATURATED
template <class I, unsigned N> constexpr exact_vec<N> saturated_shift(const exact_vec<N>& a, const vec<I, N>& amount) {
    return detail::map([](std::uint64_t x, I y) { return saturated_shift(x, static_cast<std::uint64_t>(y)); }, a,
                       amount);
}

namespace detail {
[[noreturn]] GLIFT_API void throw_unfitted(std::uint64_t value, const char* what);
}

/// Narrows to uint; throws too_large where the value does not fit, with `what` as Error::where.
inline uint fitted(std::uint64_t value, const char* what = "") {
    if (value <= UINT32_MAX) return static_cast<uint>(value);
    detail::throw_unfitted(value, what);
}
template <unsigned N> vec<uint, N> fitted(const exact_vec<N>& value, const char* what = "") {
    return detail::map([&](std::uint64_t part) { return fitted(part, what); }, value);
}

}  // namespace glift
