#include "base/half.h"

#include <gtest/gtest.h>

namespace gliftc {
namespace {

TEST(Half, rounds_to_the_nearest_and_ties_to_even) {
    EXPECT_EQ(round_to_half(1.0), 1.0);
    EXPECT_EQ(round_to_half(2049.0), 2048.0);
    EXPECT_EQ(round_to_half(2051.0), 2052.0);
    EXPECT_EQ(round_to_half(-0.1), -0.0999755859375);
}

TEST(Half, has_denormals_and_infinities) {
    EXPECT_EQ(round_to_half(0x1p-24), 0x1p-24);
    EXPECT_EQ(round_to_half(0x1p-25), 0.0);
    EXPECT_EQ(round_to_half(65519.0), 65504.0);
    EXPECT_EQ(round_to_half(-65520.0), -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace gliftc
