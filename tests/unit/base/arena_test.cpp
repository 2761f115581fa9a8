#include "base/arena.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace gliftc {
namespace {

TEST(Arena, ExtendsAnother) {
    for (std::uint32_t count : {0u, 1u, 255u, 256u, 257u, 1000u}) {
        Arena<std::string> base;
        for (std::uint32_t i = 0; i < count; ++i) base.add("base " + std::to_string(i));
        auto one = Arena<std::string>::extending(base), other = Arena<std::string>::extending(base);
        const Id<std::string> mine = one.add("one");
        EXPECT_EQ(mine.index, count);
        EXPECT_EQ(other.add("other"), mine);
        for (std::uint32_t i = 0; i < count; ++i) EXPECT_EQ(one[{i}], "base " + std::to_string(i));
        EXPECT_EQ(one[mine], "one");
        EXPECT_EQ(other[mine], "other");
        EXPECT_EQ(base.size(), count);
    }
}

TEST(Arena, TakesDownItsOwnValuesOnly) {
    const auto counted = std::make_shared<int>();
    Arena<std::shared_ptr<int>> base;
    for (int i = 0; i < 300; ++i) base.add(counted);
    {
        auto extended = Arena<std::shared_ptr<int>>::extending(base);
        for (int i = 0; i < 300; ++i) extended.add(counted);
        const auto moved = std::move(extended);
        EXPECT_EQ(moved.size(), 600u);
    }
    EXPECT_EQ(counted.use_count(), 301);
    base.truncate(0);
    EXPECT_EQ(counted.use_count(), 1);
}

TEST(Arena, AdoptsBlocks) {
    const auto counted = std::make_shared<int>();
    {
        Arena<std::shared_ptr<int>> trunk;
        trunk.add(counted);
        trunk.fill_block();
        const std::uint32_t begin = trunk.size();
        {
            auto branch = Arena<std::shared_ptr<int>>::extending(trunk);
            std::vector<std::uint32_t> ends{branch.size()};
            for (int count : {1, 64, 100}) {
                for (int i = 0; i < count; ++i) branch.add(counted);
                branch.fill_block();
                ends.push_back(branch.size());
            }
            trunk.adopt(branch, ends[2], ends[3]);  // not in the order in which they were made
            trunk.adopt(branch, ends[0], ends[1]);
            branch.add(counted);
        }
        EXPECT_EQ(trunk[{begin + 99}], counted);
        EXPECT_EQ(trunk[{begin + 100}], nullptr);
        EXPECT_EQ(trunk[{begin + 128}], counted);
        EXPECT_EQ(trunk.size(), begin + 192);
        EXPECT_EQ(trunk.add(counted).index, begin + 192);
        EXPECT_EQ(counted.use_count(), 1 + 1 + 100 + 1 + 1);
    }
    EXPECT_EQ(counted.use_count(), 1);
}

}  // namespace
}  // namespace gliftc
