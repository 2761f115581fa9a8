// The built-in functions of the language for scalars, vectors and matrices, with the semantics of GLSL where GLSL
// defines the result. Those that compiler/ir/intrinsics.def marks as exact give the same bits as on a GPU, but for what
// docs/reference/language.md, Accuracy, excepts (the bits of a NaN, the sign of a zero).
#pragma once

#include <glift/vector.h>

#include <bit>
#include <cmath>
#include <limits>

namespace glift {

namespace detail {

/// The type that arithmetic on T is done in: float for half.
template <class T> using wide = std::conditional_t<std::is_same_v<T, half>, float, T>;

template <class T> inline constexpr bool is_scalar = std::is_arithmetic_v<T> || std::is_same_v<T, half>;

}  // namespace detail

// Each macro adds, to a function `name` of one, two or three scalars, overloads that apply it to each component of
// vectors. GLIFT_MATH_2 also adds one whose second argument is a scalar, which is broadcast.
#define GLIFT_MATH_1(name)                                                                                             \
    template <class T, unsigned N> constexpr auto name(const vec<T, N>& a) {                                           \
        return detail::map([](T x) { return name(x); }, a);                                                            \
    }
#define GLIFT_MATH_2(name)                                                                                             \
    template <class T, unsigned N> constexpr auto name(const vec<T, N>& a, const vec<T, N>& b) {                       \
        return detail::map([](T x, T y) { return name(x, y); }, a, b);                                                 \
    }                                                                                                                  \
    template <class T, unsigned N> constexpr auto name(const vec<T, N>& a, detail::same<T> b) {                        \
        return name(a, vec<T, N>(b));                                                                                  \
    }
#define GLIFT_MATH_3(name)                                                                                             \
    template <class T, unsigned N> constexpr auto name(const vec<T, N>& a, const vec<T, N>& b, const vec<T, N>& c) {   \
        return detail::map([](T x, T y, T z) { return name(x, y, z); }, a, b, c);                                      \
    }

// ------------------------------------------------------------------------------------------------ exact everywhere

template <class T>
requires detail::is_scalar<T>
constexpr T abs(T x) {
    if constexpr (is_floating<T>) return static_cast<T>(__builtin_fabs(x));
    else if constexpr (std::is_signed_v<T>) return x < 0 ? detail::subtract(T{0}, x) : x;
    else return x;
}
constexpr float abs(float x) { return __builtin_fabsf(x); }

template <class T>
requires detail::is_scalar<T>
constexpr T sign(T x) { return x > T{0} ? T{1} : x < T{0} ? T(-1) : T{0}; }

inline float floor(float x) { return __builtin_floorf(x); }
inline double floor(double x) { return __builtin_floor(x); }
inline half floor(half x) { return floor(static_cast<float>(x)); }
inline float ceil(float x) { return __builtin_ceilf(x); }
inline double ceil(double x) { return __builtin_ceil(x); }
inline half ceil(half x) { return ceil(static_cast<float>(x)); }
inline float trunc(float x) { return __builtin_truncf(x); }
inline double trunc(double x) { return __builtin_trunc(x); }
inline half trunc(half x) { return trunc(static_cast<float>(x)); }
/// Rounds numbers halfway between two integers to the even one.
inline float round(float x) { return __builtin_rintf(x); }
inline double round(double x) { return __builtin_rint(x); }
inline half round(half x) { return round(static_cast<float>(x)); }
inline float sqrt(float x) { return __builtin_sqrtf(x); }
inline double sqrt(double x) { return __builtin_sqrt(x); }
inline half sqrt(half x) { return sqrt(static_cast<float>(x)); }

/// x modulo y, with the sign of y; each operation is rounded, as in shaders.
template <class T>
requires is_floating<T> T mod(T x, detail::same<T> y) { return x - y * floor(x / y); }
template <class T>
requires is_floating<T> T fract(T x) { return x - floor(x); }

/// min and max: if one value is NaN, the result is the other one.
template <class T>
requires detail::is_scalar<T>
constexpr T min(T a, detail::same<T> b) {
    if constexpr (is_floating<T>) return b < a || a != a ? b : a;
    else return b < a ? b : a;
}
template <class T>
requires detail::is_scalar<T>
constexpr T max(T a, detail::same<T> b) {
    if constexpr (is_floating<T>) return a < b || a != a ? b : a;
    else return a < b ? b : a;
}
template <class T>
requires detail::is_scalar<T>
constexpr T clamp(T x, detail::same<T> low, detail::same<T> high) { return min(max(x, low), high); }

template <class T>
requires is_floating<T>
constexpr bool isnan(T x) { return x != x; }
template <class T>
requires is_floating<T>
constexpr bool isinf(T x) { return x == T(__builtin_inf()) || x == T(-__builtin_inf()); }

template <class T>
requires is_floating<T>
constexpr T step(T edge, detail::same<T> x) { return x < edge ? T(0.0f) : T(1.0f); }
template <class T>
requires is_floating<T>
constexpr T mix(T x, detail::same<T> y, detail::same<T> a) { return x * (T(1.0f) - a) + y * a; }
template <class T>
requires is_floating<T>
constexpr T smoothstep(T low, detail::same<T> high, detail::same<T> x) {
    const T t = clamp((x - low) / (high - low), T(0.0f), T(1.0f));
    return t * t * (T(3.0f) - T(2.0f) * t);
}

GLIFT_MATH_1(abs)
GLIFT_MATH_1(sign)
GLIFT_MATH_1(floor)
GLIFT_MATH_1(ceil)
GLIFT_MATH_1(trunc)
GLIFT_MATH_1(round)
GLIFT_MATH_1(sqrt)
GLIFT_MATH_1(fract)
GLIFT_MATH_1(isnan)
GLIFT_MATH_1(isinf)
GLIFT_MATH_2(mod)
GLIFT_MATH_2(min)
GLIFT_MATH_2(max)
GLIFT_MATH_2(step)
GLIFT_MATH_3(clamp)
GLIFT_MATH_3(mix)
GLIFT_MATH_3(smoothstep)

template <class T, unsigned N>
constexpr vec<T, N> clamp(const vec<T, N>& x, detail::same<T> low, detail::same<T> high) {
    return clamp(x, vec<T, N>(low), vec<T, N>(high));
}
template <class T, unsigned N>
constexpr vec<T, N> clamp(const vec<T, N>& x, const vec<T, N>& low, detail::same<T> high) {
    return clamp(x, low, vec<T, N>(high));
}
template <class T, unsigned N>
constexpr vec<T, N> clamp(const vec<T, N>& x, detail::same<T> low, const vec<T, N>& high) {
    return clamp(x, vec<T, N>(low), high);
}
template <class T, unsigned N> constexpr vec<T, N> step(detail::same<T> edge, const vec<T, N>& x) {
    return step(vec<T, N>(edge), x);
}
template <class T, unsigned N> constexpr vec<T, N> mix(const vec<T, N>& x, const vec<T, N>& y, detail::same<T> a) {
    return mix(x, y, vec<T, N>(a));
}
template <class T, unsigned N>
constexpr vec<T, N> smoothstep(detail::same<T> low, detail::same<T> high, const vec<T, N>& x) {
    return smoothstep(vec<T, N>(low), vec<T, N>(high), x);
}

constexpr bool any(bool a) { return a; }
constexpr bool all(bool a) { return a; }
constexpr bool any(const bool2& a) { return a.x || a.y; }
constexpr bool any(const bool3& a) { return a.x || a.y || a.z; }
constexpr bool any(const bool4& a) { return a.x || a.y || a.z || a.w; }
constexpr bool all(const bool2& a) { return a.x && a.y; }
constexpr bool all(const bool3& a) { return a.x && a.y && a.z; }
constexpr bool all(const bool4& a) { return a.x && a.y && a.z && a.w; }

#define GLIFT_COMPARE(name, op)                                                                                        \
    template <class T>                                                                                                 \
    requires detail::is_scalar<T>                                                                                      \
    constexpr bool name(T a, detail::same<T> b) { return a op b; }                                                     \
    GLIFT_MATH_2(name)
GLIFT_COMPARE(lessThan, <)
GLIFT_COMPARE(lessThanEqual, <=)
GLIFT_COMPARE(greaterThan, >)
GLIFT_COMPARE(greaterThanEqual, >=)
GLIFT_COMPARE(equal, ==)
GLIFT_COMPARE(notEqual, !=)
#undef GLIFT_COMPARE

// ------------------------------------------------------------------------------------------------------------ bits

template <class T>
requires is_integer<T>
constexpr std::int32_t bitCount(T x) { return std::popcount(static_cast<std::make_unsigned_t<T>>(x)); }
/// The index of the lowest set bit; -1 where no bit is set.
template <class T>
requires is_integer<T>
constexpr std::int32_t findLSB(T x) { return x == 0 ? -1 : std::countr_zero(static_cast<std::make_unsigned_t<T>>(x)); }
/// The index of the highest set bit, of a negative value that of the highest zero bit; -1 if there is no such bit.
template <class T>
requires is_integer<T>
constexpr std::int32_t findMSB(T x) {
    using U = std::make_unsigned_t<T>;
    const U bits = x < T{0} ? static_cast<U>(~x) : static_cast<U>(x);
    return static_cast<std::int32_t>(std::bit_width(bits)) - 1;
}
template <class T>
requires is_integer<T>
constexpr T bitfieldReverse(T x) {
    using U = std::make_unsigned_t<T>;
    U from = static_cast<U>(x), to = 0;
    for (unsigned i = 0; i < sizeof(T) * 8; ++i, from >>= 1) to = static_cast<U>(to << 1) | (from & 1u);
    return static_cast<T>(to);
}
/// Bits [offset, offset + bits) as far as the type has them, sign extended for signed types. An offset outside the type
/// gives 0; negative `bits` are all bits from `offset` on.
template <class T>
requires is_integer<T>
constexpr T bitfieldExtract(T x, std::int32_t offset, std::int32_t bits) {
    constexpr std::int32_t width = sizeof(T) * 8;
    if (bits == 0 || offset < 0 || offset >= width) return 0;
    if (bits < 0 || bits > width - offset) bits = width - offset;
    using U = std::make_unsigned_t<T>;
    const U at_top = static_cast<U>(static_cast<U>(x) << (width - offset - bits));
    return static_cast<T>(static_cast<T>(at_top) >> (width - bits));
}
template <class T>
requires is_integer<T>
constexpr T bitfieldInsert(T base, T insert, std::int32_t offset, std::int32_t bits) {
    constexpr std::int32_t width = sizeof(T) * 8;
    if (bits == 0 || offset < 0 || offset >= width) return base;
    if (bits < 0 || bits > width - offset) bits = width - offset;
    using U = std::make_unsigned_t<T>;
    const U mask = static_cast<U>(static_cast<U>(~U{0} >> (width - bits)) << offset);
    return static_cast<T>((static_cast<U>(base) & static_cast<U>(~mask)) | ((static_cast<U>(insert) << offset) & mask));
}
template <class T, unsigned N>
constexpr vec<T, N> bitfieldExtract(const vec<T, N>& x, std::int32_t offset, std::int32_t bits) {
    return detail::map([=](T v) { return bitfieldExtract(v, offset, bits); }, x);
}
template <class T, unsigned N> constexpr vec<T, N> bitfieldInsert(const vec<T, N>& base, const vec<T, N>& insert,
                                                                  std::int32_t offset, std::int32_t bits) {
    return detail::map([=](T b, T i) { return bitfieldInsert(b, i, offset, bits); }, base, insert);
}
GLIFT_MATH_1(bitCount)
GLIFT_MATH_1(findLSB)
GLIFT_MATH_1(findMSB)
GLIFT_MATH_1(bitfieldReverse)

constexpr std::uint32_t floatBitsToUint(float x) { return std::bit_cast<std::uint32_t>(x); }
constexpr std::int32_t floatBitsToInt(float x) { return std::bit_cast<std::int32_t>(x); }
constexpr float uintBitsToFloat(std::uint32_t x) { return std::bit_cast<float>(x); }
constexpr float intBitsToFloat(std::int32_t x) { return std::bit_cast<float>(x); }
constexpr std::uint64_t doubleBitsToUint64(double x) { return std::bit_cast<std::uint64_t>(x); }
constexpr double uint64BitsToDouble(std::uint64_t x) { return std::bit_cast<double>(x); }
GLIFT_MATH_1(doubleBitsToUint64)
GLIFT_MATH_1(uint64BitsToDouble)
GLIFT_MATH_1(floatBitsToUint)
GLIFT_MATH_1(floatBitsToInt)
GLIFT_MATH_1(uintBitsToFloat)
GLIFT_MATH_1(intBitsToFloat)

constexpr std::uint32_t packHalf2x16(const float2& v) {
    return detail::half_bits(v.x) | static_cast<std::uint32_t>(detail::half_bits(v.y)) << 16;
}
constexpr float2 unpackHalf2x16(std::uint32_t bits) {
    return {detail::half_value(static_cast<std::uint16_t>(bits)),
            detail::half_value(static_cast<std::uint16_t>(bits >> 16))};
}
inline std::uint32_t packUnorm4x8(const float4& v) {
    const float4 scaled = round(clamp(v, 0.0f, 1.0f) * 255.0f);
    return convert<uint>(scaled.x) | convert<uint>(scaled.y) << 8 | convert<uint>(scaled.z) << 16 |
           convert<uint>(scaled.w) << 24;
}
constexpr float4 unpackUnorm4x8(std::uint32_t bits) {
    return float4(float(bits & 255u), float(bits >> 8 & 255u), float(bits >> 16 & 255u), float(bits >> 24)) / 255.0f;
}

// -------------------------------------------------------------------------------------------------------- geometry

/// Dot products are summed in the order of the components.
template <class T>
requires detail::is_scalar<T>
constexpr T dot(T a, detail::same<T> b) { return a * b; }
template <class T> constexpr T dot(const vec<T, 2>& a, const vec<T, 2>& b) { return a.x * b.x + a.y * b.y; }
template <class T> constexpr T dot(const vec<T, 3>& a, const vec<T, 3>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class T> constexpr T dot(const vec<T, 4>& a, const vec<T, 4>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
template <class T> constexpr vec<T, 3> cross(const vec<T, 3>& a, const vec<T, 3>& b) {
    return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
template <class V> auto length(const V& v) { return sqrt(dot(v, v)); }
template <class V> auto distance(const V& a, const V& b) { return length(a - b); }
template <class V> V normalize(const V& v) { return v * (decltype(length(v))(1.0f) / length(v)); }
template <class V> constexpr V reflect(const V& incident, const V& normal) {
    return incident - normal * (dot(normal, incident) * decltype(dot(normal, incident))(2.0f));
}

template <class T, unsigned C, unsigned R> constexpr mat<T, R, C> transpose(const mat<T, C, R>& m) {
    mat<T, R, C> result;
    for (unsigned c = 0; c < C; ++c) {
        for (unsigned r = 0; r < R; ++r) result.columns[r][c] = m.columns[c][r];
    }
    return result;
}
namespace detail {
/// A matrix without one of its columns and one of its rows: its determinant is a minor.
template <class T, unsigned N>
constexpr mat<T, N - 1, N - 1> minor_of(const mat<T, N, N>& m, unsigned column, unsigned row) {
    mat<T, N - 1, N - 1> result;
    for (unsigned c = 0, to = 0; c < N; ++c) {
        if (c == column) continue;
        for (unsigned r = 0, at = 0; r < N; ++r) {
            if (r != row) result.columns[to][at++] = m.columns[c][r];
        }
        ++to;
    }
    return result;
}
}  // namespace detail
template <class T, unsigned N> constexpr T determinant(const mat<T, N, N>& m) {
    if constexpr (N == 2) {
        return m.columns[0].x * m.columns[1].y - m.columns[1].x * m.columns[0].y;
    } else {
        T sum{};
        for (unsigned c = 0; c < N; ++c) {
            const T term = m.columns[c].x * determinant(detail::minor_of(m, c, 0));
            sum = c % 2 == 0 ? sum + term : sum - term;
        }
        return sum;
    }
}
template <class T, unsigned N> constexpr mat<T, N, N> inverse(const mat<T, N, N>& m) {
    const T scale = T(1.0f) / determinant(m);
    mat<T, N, N> result;
    for (unsigned c = 0; c < N; ++c) {
        for (unsigned r = 0; r < N; ++r) {
            T cofactor;
            if constexpr (N == 2) cofactor = m.columns[1 - c][1 - r];
            else cofactor = determinant(detail::minor_of(m, c, r));
            result.columns[r][c] = ((c + r) % 2 == 0 ? cofactor : -cofactor) * scale;
        }
    }
    return result;
}

// ------------------------------------------------------------------------- not exact: docs/reference/language.md has
// the bounds

#define GLIFT_INEXACT_1(name, function)                                                                                \
    template <class T>                                                                                                 \
    requires is_floating<T>                                                                                            \
    inline T name(T x) { return static_cast<T>(function(static_cast<detail::wide<T>>(x))); }                           \
    GLIFT_MATH_1(name)
GLIFT_INEXACT_1(exp, std::exp)
GLIFT_INEXACT_1(exp2, std::exp2)
GLIFT_INEXACT_1(log, std::log)
GLIFT_INEXACT_1(log2, std::log2)
GLIFT_INEXACT_1(sin, std::sin)
GLIFT_INEXACT_1(cos, std::cos)
GLIFT_INEXACT_1(tan, std::tan)
GLIFT_INEXACT_1(asin, std::asin)
GLIFT_INEXACT_1(acos, std::acos)
GLIFT_INEXACT_1(atan, std::atan)
GLIFT_INEXACT_1(sinh, std::sinh)
GLIFT_INEXACT_1(cosh, std::cosh)
GLIFT_INEXACT_1(tanh, std::tanh)
GLIFT_INEXACT_1(inversesqrt, 1.0f / std::sqrt)
#undef GLIFT_INEXACT_1

template <class T>
requires is_floating<T>
inline T pow(T x, detail::same<T> y) {
    return static_cast<T>(std::pow(static_cast<detail::wide<T>>(x), static_cast<detail::wide<T>>(y)));
}
template <class T>
requires is_floating<T>
inline T atan2(T y, detail::same<T> x) {
    return static_cast<T>(std::atan2(static_cast<detail::wide<T>>(y), static_cast<detail::wide<T>>(x)));
}
/// Not fused: the result is that of devices without a fused operation.
template <class T>
requires is_floating<T>
constexpr T fma(T a, detail::same<T> b, detail::same<T> c) { return a * b + c; }
GLIFT_MATH_2(pow)
GLIFT_MATH_2(atan2)
GLIFT_MATH_3(fma)

#undef GLIFT_MATH_1
#undef GLIFT_MATH_2
#undef GLIFT_MATH_3

// ------------------------------------------------------- subgroups: on the host they have one lane, which is active

namespace detail {

/// `least` is the identity of the maximum, `greatest` that of the minimum.
template <class T> constexpr T least() {
    if constexpr (std::is_same_v<T, half>) return half(-std::numeric_limits<float>::infinity());
    else if constexpr (is_floating<T>) return -std::numeric_limits<T>::infinity();
    else return std::numeric_limits<T>::min();
}
template <class T> constexpr T greatest() {
    if constexpr (std::is_same_v<T, half>) return half(std::numeric_limits<float>::infinity());
    else if constexpr (is_floating<T>) return std::numeric_limits<T>::infinity();
    else return std::numeric_limits<T>::max();
}

}  // namespace detail

template <class T> constexpr T subgroupAdd(T x) { return x; }
template <class T> constexpr T subgroupMin(T x) { return x; }
template <class T> constexpr T subgroupMax(T x) { return x; }
template <class T> constexpr T subgroupMul(T x) { return x; }
template <class T> constexpr T subgroupAnd(T x) { return x; }
template <class T> constexpr T subgroupOr(T x) { return x; }
template <class T> constexpr T subgroupXor(T x) { return x; }
template <class T> constexpr T subgroupExclusiveAdd(T) { return T{}; }
template <class T> constexpr T subgroupExclusiveMin(T) { return detail::greatest<T>(); }
template <class T> constexpr T subgroupExclusiveMax(T) { return detail::least<T>(); }
template <class T, unsigned N> constexpr vec<T, N> subgroupExclusiveMin(vec<T, N>) {
    return vec<T, N>(detail::greatest<T>());
}
template <class T, unsigned N> constexpr vec<T, N> subgroupExclusiveMax(vec<T, N>) {
    return vec<T, N>(detail::least<T>());
}
template <class T> constexpr T subgroupInclusiveAdd(T x) { return x; }
template <class T> constexpr T subgroupInclusiveMin(T x) { return x; }
template <class T> constexpr T subgroupInclusiveMax(T x) { return x; }
constexpr bool subgroupAll(bool x) { return x; }
constexpr bool subgroupAny(bool x) { return x; }
constexpr bool subgroupElect() { return true; }
template <class T> constexpr T subgroupBroadcast(T x, uint) { return x; }
template <class T> constexpr T subgroupBroadcastFirst(T x) { return x; }
template <class T> constexpr T subgroupShuffle(T x, uint) { return x; }
template <class T> constexpr T subgroupShuffleXor(T x, uint) { return x; }
template <class T> constexpr T subgroupShuffleUp(T x, uint) { return x; }
template <class T> constexpr T subgroupShuffleDown(T x, uint) { return x; }
constexpr uint4 subgroupBallot(bool x) { return {x ? 1u : 0u, 0u, 0u, 0u}; }
constexpr uint subgroupBallotCount(bool x) { return x ? 1u : 0u; }
constexpr uint subgroupBallotExclusiveCount(bool) { return 0u; }

}  // namespace glift
