// Ranges of as many elements as memory allows: GLIFT_PROPERTY_ELEMENTS says how many (100,003). Sorting pairs takes the
// most memory, 16 bytes an element.
#include "property.h"

#include "large.glift.hpp"

#include <cstdlib>

namespace {

using namespace property;

std::uint32_t elements() {
    const char* text = std::getenv("GLIFT_PROPERTY_ELEMENTS");
    return text ? static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)) : 100003;
}

GLIFT_PROPERTY_SUITE(Large);

TEST_P(Large, Scan) { EXPECT_EQ(large::wrong_sums(device(), elements()).await(device()), 0u); }

TEST_P(Large, Reduce) {
    const std::uint64_t n = elements(), sum = n % 2 ? (n - 1) / 2 * n : n / 2 * (n - 1);
    EXPECT_EQ(large::sum_of_numbers(device(), elements()).await(device()), static_cast<std::uint32_t>(sum));
}

TEST_P(Large, Compact) {
    const std::uint32_t n = elements(), expected = n - n / 16 - (n % 16 != 0);
    const large::Line kept(device(), expected);
    EXPECT_EQ(large::keep(device(), n, kept).await(device()), expected);
    EXPECT_EQ(large::wrong_kept(device(), kept).await(device()), 0u);
}

TEST_P(Large, SortPairs) { EXPECT_EQ(large::wrong_pairs(device(), elements()).await(device()), 0u); }

}  // namespace
