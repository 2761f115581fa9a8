// Vectors, matrices and arrays of the language as C++ value types, in GLSL's scalar layout: components packed, aligned
// as one component.
#pragma once

#include <glift/arithmetic.h>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace glift {

using uint = std::uint32_t;

struct Bool;

template <class T, unsigned N> struct vec;

namespace detail {

/// Whether one type is bool and the other is Bool, its form in memory: vectors of these convert implicitly.
template <class T, class U> inline constexpr bool both_bools = (std::is_same_v<T, bool> && std::is_same_v<U, Bool>) ||
                                                               (std::is_same_v<T, Bool> && std::is_same_v<U, bool>);

}  // namespace detail

template <class T> struct vec<T, 2> {
    T x{}, y{};

    constexpr vec() = default;
    constexpr vec(T a, T b) : x(a), y(b) {}
    explicit constexpr vec(T all) : x(all), y(all) {}
    template <class U> explicit(!detail::both_bools<T, U>) constexpr vec(const vec<U, 2>& v)
        : x(convert<T>(v.x)), y(convert<T>(v.y)) {}

    template <class I> constexpr T& operator[](I i) { return i <= 0 ? x : y; }
    template <class I> constexpr const T& operator[](I i) const { return i <= 0 ? x : y; }
    constexpr bool operator==(const vec&) const = default;
};

template <class T> struct vec<T, 3> {
    T x{}, y{}, z{};

    constexpr vec() = default;
    constexpr vec(T a, T b, T c) : x(a), y(b), z(c) {}
    explicit constexpr vec(T all) : x(all), y(all), z(all) {}
    constexpr vec(const vec<T, 2>& v, T c) : x(v.x), y(v.y), z(c) {}
    constexpr vec(T a, const vec<T, 2>& v) : x(a), y(v.x), z(v.y) {}
    template <class U> explicit(!detail::both_bools<T, U>) constexpr vec(const vec<U, 3>& v)
        : x(convert<T>(v.x)), y(convert<T>(v.y)), z(convert<T>(v.z)) {}

    template <class I> constexpr T& operator[](I i) { return i <= 0 ? x : i == 1 ? y : z; }
    template <class I> constexpr const T& operator[](I i) const { return i <= 0 ? x : i == 1 ? y : z; }
    constexpr bool operator==(const vec&) const = default;

    constexpr vec<T, 2> xy() const { return {x, y}; }
    constexpr vec<T, 2> yz() const { return {y, z}; }
};

template <class T> struct vec<T, 4> {
    T x{}, y{}, z{}, w{};

    constexpr vec() = default;
    constexpr vec(T a, T b, T c, T d) : x(a), y(b), z(c), w(d) {}
    explicit constexpr vec(T all) : x(all), y(all), z(all), w(all) {}
    constexpr vec(const vec<T, 2>& a, const vec<T, 2>& b) : x(a.x), y(a.y), z(b.x), w(b.y) {}
    constexpr vec(const vec<T, 2>& v, T c, T d) : x(v.x), y(v.y), z(c), w(d) {}
    constexpr vec(T a, const vec<T, 2>& v, T d) : x(a), y(v.x), z(v.y), w(d) {}
    constexpr vec(T a, T b, const vec<T, 2>& v) : x(a), y(b), z(v.x), w(v.y) {}
    constexpr vec(const vec<T, 3>& v, T d) : x(v.x), y(v.y), z(v.z), w(d) {}
    constexpr vec(T a, const vec<T, 3>& v) : x(a), y(v.x), z(v.y), w(v.z) {}
    template <class U> explicit(!detail::both_bools<T, U>) constexpr vec(const vec<U, 4>& v)
        : x(convert<T>(v.x)), y(convert<T>(v.y)), z(convert<T>(v.z)), w(convert<T>(v.w)) {}

    template <class I> constexpr T& operator[](I i) { return i <= 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    template <class I> constexpr const T& operator[](I i) const { return i <= 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    constexpr bool operator==(const vec&) const = default;

    constexpr vec<T, 2> xy() const { return {x, y}; }
    constexpr vec<T, 2> yz() const { return {y, z}; }
    constexpr vec<T, 2> zw() const { return {z, w}; }
    constexpr vec<T, 3> xyz() const { return {x, y, z}; }
    constexpr vec<T, 3> yzw() const { return {y, z, w}; }
};

namespace detail {

template <class F, class T, unsigned N> constexpr auto map(F f, const vec<T, N>& a) {
    using R = decltype(f(a.x));
    if constexpr (N == 2) return vec<R, 2>(f(a.x), f(a.y));
    else if constexpr (N == 3) return vec<R, 3>(f(a.x), f(a.y), f(a.z));
    else return vec<R, 4>(f(a.x), f(a.y), f(a.z), f(a.w));
}

template <class F, class T, class U, unsigned N> constexpr auto map(F f, const vec<T, N>& a, const vec<U, N>& b) {
    using R = decltype(f(a.x, b.x));
    if constexpr (N == 2) return vec<R, 2>(f(a.x, b.x), f(a.y, b.y));
    else if constexpr (N == 3) return vec<R, 3>(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z));
    else return vec<R, 4>(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z), f(a.w, b.w));
}

template <class F, class T, class U, class V, unsigned N>
constexpr auto map(F f, const vec<T, N>& a, const vec<U, N>& b, const vec<V, N>& c) {
    using R = decltype(f(a.x, b.x, c.x));
    if constexpr (N == 2) return vec<R, 2>(f(a.x, b.x, c.x), f(a.y, b.y, c.y));
    else if constexpr (N == 3) return vec<R, 3>(f(a.x, b.x, c.x), f(a.y, b.y, c.y), f(a.z, b.z, c.z));
    else return vec<R, 4>(f(a.x, b.x, c.x), f(a.y, b.y, c.y), f(a.z, b.z, c.z), f(a.w, b.w, c.w));
}

// Signed arithmetic wraps as unsigned does.
template <class T> constexpr T add(T a, T b) {
    if constexpr (is_integer<T>) {
        using U = std::make_unsigned_t<T>;
        return static_cast<T>(static_cast<U>(a) + static_cast<U>(b));
    } else {
        return a + b;
    }
}
template <class T> constexpr T subtract(T a, T b) {
    if constexpr (is_integer<T>) {
        using U = std::make_unsigned_t<T>;
        return static_cast<T>(static_cast<U>(a) - static_cast<U>(b));
    } else {
        return a - b;
    }
}
template <class T> constexpr T multiply(T a, T b) {
    if constexpr (is_integer<T>) {
        using U = std::make_unsigned_t<T>;
        return static_cast<T>(static_cast<U>(a) * static_cast<U>(b));
    } else {
        return a * b;
    }
}

template <class T> struct Same { using type = T; };
template <class T> using same = typename Same<T>::type;  // not deduced, so that `v * 2` takes v's component type

}  // namespace detail

// Componentwise operators; a scalar operand is broadcast.
#define GLIFT_VECTOR_OPERATOR(op, function)                                                                            \
    template <class T, unsigned N> constexpr vec<T, N> operator op(const vec<T, N>& a, const vec<T, N>& b) {           \
        return detail::map([](T l, T r) -> T { return function; }, a, b);                                              \
    }                                                                                                                  \
    template <class T, unsigned N> constexpr vec<T, N> operator op(const vec<T, N>& a, detail::same<T> b) {            \
        return a op vec<T, N>(b);                                                                                      \
    }                                                                                                                  \
    template <class T, unsigned N> constexpr vec<T, N> operator op(detail::same<T> a, const vec<T, N>& b) {            \
        return vec<T, N>(a) op b;                                                                                      \
    }                                                                                                                  \
    template <class T, unsigned N> constexpr vec<T, N>& operator op##=(vec<T, N>& a, const vec<T, N>& b) {             \
        return a = a op b;                                                                                             \
    }                                                                                                                  \
    template <class T, unsigned N> constexpr vec<T, N>& operator op##=(vec<T, N>& a, detail::same<T> b) {              \
        return a = a op b;                                                                                             \
    }

GLIFT_VECTOR_OPERATOR(+, detail::add(l, r))
GLIFT_VECTOR_OPERATOR(-, detail::subtract(l, r))
GLIFT_VECTOR_OPERATOR(*, detail::multiply(l, r))
GLIFT_VECTOR_OPERATOR(/, divide(l, r))
GLIFT_VECTOR_OPERATOR(%, remainder(l, r))
GLIFT_VECTOR_OPERATOR(&, static_cast<T>(l& r))
GLIFT_VECTOR_OPERATOR(|, static_cast<T>(l | r))
GLIFT_VECTOR_OPERATOR(^, static_cast<T>(l ^ r))
#undef GLIFT_VECTOR_OPERATOR

template <class T, class U, unsigned N> constexpr vec<T, N> operator<<(const vec<T, N>& a, const vec<U, N>& b) {
    return detail::map([](T l, U r) { return shift_left(l, r); }, a, b);
}
template <class T, class U, unsigned N>
requires is_integer<U>
constexpr vec<T, N> operator<<(const vec<T, N>& a, U b) {
    return detail::map([b](T l) { return shift_left(l, b); }, a);
}
template <class T, class U, unsigned N> constexpr vec<T, N> operator>>(const vec<T, N>& a, const vec<U, N>& b) {
    return detail::map([](T l, U r) { return shift_right(l, r); }, a, b);
}
template <class T, class U, unsigned N>
requires is_integer<U>
constexpr vec<T, N> operator>>(const vec<T, N>& a, U b) {
    return detail::map([b](T l) { return shift_right(l, b); }, a);
}
template <class T, unsigned N> constexpr vec<T, N> operator-(const vec<T, N>& a) {
    if constexpr (is_integer<T>) return vec<T, N>(T{0}) - a;
    else return detail::map([](T v) { return -v; }, a);
}
template <class T, unsigned N> constexpr vec<T, N> operator~(const vec<T, N>& a) {
    return detail::map([](T v) { return static_cast<T>(~v); }, a);
}
template <unsigned N> constexpr vec<bool, N> operator!(const vec<bool, N>& a) {
    return detail::map([](bool v) { return !v; }, a);
}

/// v.yx is swizzle<1, 0>(v).
template <unsigned... Lanes, class T, unsigned N> constexpr vec<T, sizeof...(Lanes)> swizzle(const vec<T, N>& v) {
    return {v[Lanes]...};
}

/// v.zx = value is assign_swizzle<2, 0>(v, value).
template <unsigned... Lanes, class T, unsigned N, class U>
constexpr void assign_swizzle(vec<T, N>& v, vec<U, sizeof...(Lanes)> value) {
    unsigned i = 0;
    ((v[Lanes] = value[i++]), ...);
}

using bool2 = vec<bool, 2>;
using bool3 = vec<bool, 3>;
using bool4 = vec<bool, 4>;
using int2 = vec<std::int32_t, 2>;
using int3 = vec<std::int32_t, 3>;
using int4 = vec<std::int32_t, 4>;
using uint2 = vec<std::uint32_t, 2>;
using uint3 = vec<std::uint32_t, 3>;
using uint4 = vec<std::uint32_t, 4>;
using float2 = vec<float, 2>;
using float3 = vec<float, 3>;
using float4 = vec<float, 4>;
using half2 = vec<half, 2>;
using half3 = vec<half, 3>;
using half4 = vec<half, 4>;
using double2 = vec<double, 2>;
using double3 = vec<double, 3>;
using double4 = vec<double, 4>;

namespace detail {
/// Clamps an index to an array of N elements.
template <unsigned N, class I> constexpr unsigned within(I i) {
    if constexpr (std::is_signed_v<I>) return i < 0 ? 0 : i < static_cast<I>(N) ? static_cast<unsigned>(i) : N - 1;
    else return i < N ? static_cast<unsigned>(i) : N - 1;
}
}  // namespace detail

/// The language's array `T[n]`; indices out of range are clamped.
template <class T, unsigned N> struct array {
    T values[N] = {};

    template <class I> constexpr T& operator[](I i) { return values[detail::within<N>(i)]; }
    template <class I> constexpr const T& operator[](I i) const { return values[detail::within<N>(i)]; }
    constexpr bool operator==(const array&) const = default;
    static constexpr unsigned size() { return N; }
    constexpr T* begin() { return values; }
    constexpr T* end() { return values + N; }
    constexpr const T* begin() const { return values; }
    constexpr const T* end() const { return values + N; }
};

/// Sets a value, such as an array, to zeros. (g++ 12 rejects `a = {}` and `a = array<T, N>{}` where T has default
/// member initialisers.)
template <class T> constexpr void reset(T& value) {
    const T zeros{};
    value = zeros;
}

/// C columns of R rows, column after column; m[c] is a column.
template <class T, unsigned C, unsigned R> struct mat {
    vec<T, R> columns[C] = {};

    template <class I> constexpr vec<T, R>& operator[](I c) { return columns[detail::within<C>(c)]; }
    template <class I> constexpr const vec<T, R>& operator[](I c) const { return columns[detail::within<C>(c)]; }
    constexpr bool operator==(const mat&) const = default;
};

using float2x2 = mat<float, 2, 2>;
using float3x3 = mat<float, 3, 3>;
using float4x4 = mat<float, 4, 4>;
using float2x3 = mat<float, 2, 3>;
using float2x4 = mat<float, 2, 4>;
using float3x2 = mat<float, 3, 2>;
using float3x4 = mat<float, 3, 4>;
using float4x2 = mat<float, 4, 2>;
using float4x3 = mat<float, 4, 3>;

/// The terms are summed in the order of the columns, so that the result is the same on every device.
template <class T, unsigned C, unsigned R> constexpr vec<T, R> operator*(const mat<T, C, R>& m, const vec<T, C>& v) {
    vec<T, R> sum = m.columns[0] * v.x;
    for (unsigned c = 1; c < C; ++c) sum += m.columns[c] * v[c];
    return sum;
}
template <class T, unsigned C, unsigned R> constexpr vec<T, C> operator*(const vec<T, R>& v, const mat<T, C, R>& m) {
    vec<T, C> result;
    for (unsigned c = 0; c < C; ++c) {
        result[c] = v.x * m.columns[c].x;
        for (unsigned r = 1; r < R; ++r) result[c] += v[r] * m.columns[c][r];
    }
    return result;
}
template <class T, unsigned K, unsigned C, unsigned R>
constexpr mat<T, C, R> operator*(const mat<T, K, R>& a, const mat<T, C, K>& b) {
    mat<T, C, R> result;
    for (unsigned c = 0; c < C; ++c) result.columns[c] = a * b.columns[c];
    return result;
}
template <class T, unsigned C, unsigned R> constexpr mat<T, C, R> operator*(const mat<T, C, R>& a, detail::same<T> b) {
    mat<T, C, R> result;
    for (unsigned c = 0; c < C; ++c) result.columns[c] = a.columns[c] * b;
    return result;
}
template <class T, unsigned C, unsigned R> constexpr mat<T, C, R> operator*(detail::same<T> a, const mat<T, C, R>& b) {
    return b * a;
}
template <class T, unsigned C, unsigned R>
constexpr mat<T, C, R> operator+(const mat<T, C, R>& a, const mat<T, C, R>& b) {
    mat<T, C, R> result;
    for (unsigned c = 0; c < C; ++c) result.columns[c] = a.columns[c] + b.columns[c];
    return result;
}
template <class T, unsigned C, unsigned R>
constexpr mat<T, C, R> operator-(const mat<T, C, R>& a, const mat<T, C, R>& b) {
    mat<T, C, R> result;
    for (unsigned c = 0; c < C; ++c) result.columns[c] = a.columns[c] - b.columns[c];
    return result;
}
template <class T, unsigned C, unsigned R> constexpr mat<T, C, R> operator-(const mat<T, C, R>& a) { return a * T{-1}; }
template <class T, unsigned C, unsigned R> constexpr mat<T, C, R>& operator+=(mat<T, C, R>& a, const mat<T, C, R>& b) {
    return a = a + b;
}
template <class T, unsigned C, unsigned R> constexpr mat<T, C, R>& operator-=(mat<T, C, R>& a, const mat<T, C, R>& b) {
    return a = a - b;
}
template <class T, unsigned C, unsigned R> constexpr mat<T, C, R>& operator*=(mat<T, C, R>& a, detail::same<T> b) {
    return a = a * b;
}
template <class T, unsigned C, unsigned R> constexpr mat<T, C, R>& operator*=(mat<T, C, R>& a, const mat<T, C, C>& b) {
    return a = a * b;
}
template <class T, unsigned N> constexpr vec<T, N>& operator*=(vec<T, N>& a, const mat<T, N, N>& b) {
    return a = a * b;
}

/// The names of the language's own types, for `using namespace glift::types;`.
namespace types {
using glift::bool2, glift::bool3, glift::bool4, glift::int2, glift::int3, glift::int4;
using glift::double2, glift::double3, glift::double4, glift::uint2, glift::uint3, glift::uint4;
using glift::float2, glift::float3, glift::float4, glift::half2, glift::half3, glift::half4;
using glift::float2x2, glift::float2x3, glift::float2x4, glift::float3x2, glift::float3x3, glift::float3x4;
using glift::float4x2, glift::float4x3, glift::float4x4;
using glift::half, glift::uint;
}  // namespace types

}  // namespace glift
