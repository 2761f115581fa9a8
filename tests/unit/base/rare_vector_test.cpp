#include "base/rare_vector.h"

#include <gtest/gtest.h>

#include <string>

namespace {

using gliftc::RareVector;

TEST(RareVector, IsEmptyAndSmallAtFirst) {
    RareVector<std::string> values;
    EXPECT_TRUE(values.empty());
    EXPECT_EQ(values.begin(), values.end());
    EXPECT_EQ(sizeof values, sizeof(void*));
    const std::vector<std::string>& seen = values;
    EXPECT_TRUE(seen.empty());
}

TEST(RareVector, CopiesAreTheirOwn) {
    RareVector<std::string> values{"a", "b"};
    RareVector<std::string> copy = values;
    copy.push_back("c");
    EXPECT_EQ(values.size(), 2u);
    EXPECT_EQ(copy.size(), 3u);
    EXPECT_EQ(copy.back(), "c");
    EXPECT_FALSE(values == copy);
    copy = values;
    EXPECT_TRUE(values == copy);
}

TEST(RareVector, AppendsAndComparesWithVectors) {
    RareVector<int> values;
    values.append(std::vector<int>{});
    EXPECT_TRUE(values.empty());
    values.append(std::vector<int>{1, 2});
    values.append(RareVector<int>{3});
    EXPECT_TRUE(values == (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(values[2], 3);
}

}  // namespace
