#include "base/name.h"

#include <gtest/gtest.h>

namespace gliftc {
namespace {

TEST(Names, ExtendOthers) {
    Names base;
    const Name known = base.intern("known");
    Names names = Names::extending(base);
    EXPECT_EQ(names.intern("known"), known);
    EXPECT_EQ(names.intern(""), Name{});
    for (int i = 0; i < 1000; ++i) {
        const std::string text = "name" + std::to_string(i);
        const Name made = names.intern(text);
        EXPECT_EQ(made.index, base.size() + static_cast<std::uint32_t>(i));
        EXPECT_EQ(names[made], text);
    }
    EXPECT_EQ(names.intern("name7").index, base.size() + 7);
    EXPECT_EQ(names[known], "known");
    EXPECT_EQ(names.size(), base.size() + 1000);
    EXPECT_EQ(base.size(), 2u);
}

}  // namespace
}  // namespace gliftc
