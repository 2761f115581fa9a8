#include "base/id_set.h"

#include <gtest/gtest.h>

namespace gliftc {
namespace {

struct Node;

TEST(IdSet, knows_what_it_has_seen) {
    IdSet<Node> seen;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        EXPECT_FALSE(seen.contains({i * 64}));
        EXPECT_TRUE(seen.insert({i * 64}));
        EXPECT_FALSE(seen.insert({i * 64}));
    }
    for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_TRUE(seen.contains({i * 64}));
    EXPECT_FALSE(seen.contains({1}));
    seen.clear();
    EXPECT_FALSE(seen.contains({64}));
    EXPECT_TRUE(seen.insert({64}));
}

}  // namespace
}  // namespace gliftc
