#include "base/small_vector.h"

#include <gtest/gtest.h>

namespace gliftc {
namespace {

using Numbers = SmallVector<std::uint32_t, 4>;

Numbers counted(std::uint32_t count) {
    Numbers numbers;
    for (std::uint32_t i = 0; i < count; ++i) numbers.push_back(i);
    return numbers;
}

TEST(SmallVector, holds_few_and_many) {
    for (std::uint32_t count : {0u, 1u, 4u, 5u, 100u}) {
        const Numbers numbers = counted(count);
        ASSERT_EQ(numbers.size(), count);
        for (std::uint32_t i = 0; i < count; ++i) EXPECT_EQ(numbers[i], i);
    }
}

TEST(SmallVector, copies_are_apart) {
    for (std::uint32_t count : {3u, 9u}) {
        const Numbers original = counted(count);
        Numbers copy = original;
        copy[0] = 7;
        EXPECT_EQ(original[0], 0u);
        copy = original;
        EXPECT_EQ(copy, original);
        const Numbers& same = copy;
        copy = same;
        EXPECT_EQ(copy, original);
    }
}

TEST(SmallVector, is_empty_after_it_was_moved) {
    for (std::uint32_t count : {3u, 9u}) {
        Numbers from = counted(count), to = counted(20);
        to = std::move(from);
        EXPECT_EQ(to, counted(count));
        EXPECT_TRUE(from.empty());
        from.push_back(5);
        EXPECT_EQ(from, Numbers{5});
    }
}

TEST(SmallVector, appends_and_assigns) {
    Numbers numbers = counted(3);
    numbers.append(counted(4));
    EXPECT_EQ(numbers, (Numbers{0, 1, 2, 0, 1, 2, 3}));
    numbers.append(numbers);
    EXPECT_EQ(numbers.size(), 14u);
    EXPECT_EQ(numbers.back(), 3u);
    numbers.assign(5, 8);
    EXPECT_EQ(numbers, (Numbers{8, 8, 8, 8, 8}));
}

}  // namespace
}  // namespace gliftc
