// The language's functions in C++, also for operands for which C++ defines no result; the memory layout of the
// language's types.
#include <glift/host/math.h>

#include <gtest/gtest.h>

#include <limits>

using namespace glift;

static_assert(sizeof(float3) == 12 && alignof(float4) == 4 && sizeof(half3) == 6 && sizeof(float3x4) == 48);
static_assert(sizeof(array<float3, 5>) == 60 && sizeof(Bool) == 4);

TEST(Arithmetic, DividesByZeroAsByOne) {
    EXPECT_EQ(divide(7u, 0u), 7u);
    EXPECT_EQ(remainder(7u, 0u), 0u);
    EXPECT_EQ(divide(INT32_MIN, -1), INT32_MIN);
    EXPECT_EQ(remainder(INT32_MIN, -1), 0);
    EXPECT_EQ(divide(-7, 2), -3);
    EXPECT_EQ(remainder(-7, 3), -1);
    EXPECT_EQ(uint2(8, 9) / uint2(0, 2), uint2(8, 4));
}

TEST(Arithmetic, ModOfFloatsHasTheDivisorsSign) {
    EXPECT_EQ(mod(-1.0f, 3.0f), 2.0f);
    EXPECT_EQ(mod(5.5f, 2.0f), 1.5f);
}

TEST(Arithmetic, WrapsAndShiftsModuloTheWidth) {
    EXPECT_EQ(int2(INT32_MAX, 1) + 1, int2(INT32_MIN, 2));
    EXPECT_EQ(shift_left(1u, 33u), 2u);
    EXPECT_EQ(shift_right(-8, 1), -4);
    EXPECT_EQ(-int2(INT32_MIN, 3), int2(INT32_MIN, -3));
}

TEST(Arithmetic, ConvertsFloatsToTheNearestIntegerThatFits) {
    EXPECT_EQ(convert<int>(1e20f), INT32_MAX);
    EXPECT_EQ(convert<int>(-1e20f), INT32_MIN);
    EXPECT_EQ(convert<uint>(-1.5f), 0u);
    EXPECT_EQ(convert<uint>(4294967040.0f), 4294967040u);
    EXPECT_EQ(convert<int>(std::numeric_limits<float>::quiet_NaN()), 0);
    EXPECT_EQ(convert<int>(-2.9f), -2);
}

TEST(Half, RoundsToNearestEvenBothWays) {
    for (std::uint32_t bits = 0; bits < 0x7c00u; ++bits) {
        const float value = detail::half_value(static_cast<std::uint16_t>(bits));
        EXPECT_EQ(detail::half_bits(value), bits);
        const float above = detail::half_value(static_cast<std::uint16_t>(bits + 1));
        if (bits + 1 == 0x7c00u) break;
        EXPECT_EQ(detail::half_bits((value + above) / 2), bits + (bits & 1));
    }
    EXPECT_EQ(detail::half_bits(65520.0f), 0x7c00u);
    EXPECT_EQ(detail::half_bits(65519.0f), 0x7bffu);
    EXPECT_EQ(detail::half_bits(-0.0f), 0x8000u);
}

TEST(Math, MinAndMaxPreferNumbers) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(min(nan, 1.0f), 1.0f);
    EXPECT_EQ(min(1.0f, nan), 1.0f);
    EXPECT_EQ(max(nan, 1.0f), 1.0f);
    EXPECT_EQ(clamp(5.0f, 3.0f, 2.0f), 2.0f);
}

TEST(Math, RoundsHalfToEven) {
    EXPECT_EQ(round(0.5f), 0.0f);
    EXPECT_EQ(round(1.5f), 2.0f);
    EXPECT_EQ(round(float2(-2.5f, 2.6f)), float2(-2.0f, 3.0f));
}

TEST(Math, FindsAndMovesBits) {
    EXPECT_EQ(findMSB(0u), -1);
    EXPECT_EQ(findMSB(-1), -1);
    EXPECT_EQ(findMSB(-2), 0);
    EXPECT_EQ(findLSB(8u), 3);
    EXPECT_EQ(bitfieldExtract(0xf0u, 4, 4), 15u);
    EXPECT_EQ(bitfieldExtract(0xf0, 4, 4), -1);
    EXPECT_EQ(bitfieldExtract(0xffffffffu, 30, 9), 3u);
    EXPECT_EQ(bitfieldInsert(0u, 0xffu, 4, 4), 0xf0u);
    EXPECT_EQ(bitfieldReverse(1u), 0x80000000u);
}

TEST(Math, PacksColours) {
    EXPECT_EQ(packUnorm4x8(float4(1, 0, 0.5f, 2)), 0xff8000ffu);
    EXPECT_EQ(unpackUnorm4x8(0xff0000ffu), float4(1, 0, 0, 1));
    EXPECT_EQ(packHalf2x16(float2(1, -2)), 0xc0003c00u);
}

TEST(Math, InvertsMatrices) {
    float3x3 m{{{2, 1, 0}, {0, 3, 0}, {1, 0, 4}}};
    const float3x3 one = m * inverse(m);
    for (unsigned c = 0; c < 3; ++c) {
        for (unsigned r = 0; r < 3; ++r) EXPECT_NEAR(one[c][r], c == r ? 1.0f : 0.0f, 1e-6f);
    }
    EXPECT_EQ(determinant(m), 24.0f);
    EXPECT_EQ(transpose(m)[0], float3(2, 0, 1));
}

TEST(Vector, IndexesWithinItsEnds) {
    const array<int, 3> a{{1, 2, 3}};
    EXPECT_EQ(a[7u], 3);
    EXPECT_EQ(a[-4], 1);
    float4 v(1, 2, 3, 4);
    EXPECT_EQ(v[9], 4.0f);
    assign_swizzle<3, 0>(v, float2(7, 8));
    EXPECT_EQ(v, float4(8, 2, 3, 7));
    EXPECT_EQ((swizzle<1, 1>(v)), float2(2, 2));
}
