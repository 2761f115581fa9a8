// Algorithms over GLIFT_PROPERTY_ELEMENTS elements (default 100,003); fewer where they are stored and would exceed the
// device's largest allocation. Sorting pairs takes 16 bytes per element for keys, values and temporaries of the same
// sizes, and up to 2 for counts.
#include "property.h"

#include "large.glift.hpp"

#include <algorithm>
#include <cstdlib>

namespace {

using namespace property;

std::uint32_t elements() {
    const char* text = std::getenv("GLIFT_PROPERTY_ELEMENTS");
    return text ? static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)) : 100003;
}

std::uint32_t elements_in_memory(const glift::Device& device) {
    const std::uint64_t most = device.properties().max_allocation_bytes / sizeof(std::uint32_t);
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(elements(), most));
}

GLIFT_PROPERTY_SUITE(Large);

TEST_P(Large, Scan) { EXPECT_EQ(large::wrong_sums(device(), elements_in_memory(device())).await(device()), 0u); }

TEST_P(Large, Reduce) {
    const std::uint64_t n = elements(), sum = n % 2 ? (n - 1) / 2 * n : n / 2 * (n - 1);
    EXPECT_EQ(large::sum_of_numbers(device(), elements()).await(device()), static_cast<std::uint32_t>(sum));
}

TEST_P(Large, Compact) {
    const std::uint32_t n = elements(), expected = n / 16 + (n % 16 != 0);
    const large::Line kept(device(), expected);
    EXPECT_EQ(large::keep(device(), n, kept).await(device()), expected);
    EXPECT_EQ(large::wrong_kept(device(), kept).await(device()), 0u);
}

TEST_P(Large, SortPairs) { EXPECT_EQ(large::wrong_pairs(device(), elements_in_memory(device())).await(device()), 0u); }

}  // namespace
