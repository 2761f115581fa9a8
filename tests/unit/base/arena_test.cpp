#include "base/arena.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

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

}  // namespace
}  // namespace gliftc
