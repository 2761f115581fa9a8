// Names in GLSL: a name that is taken gets a number; a name that would still be reserved with a number gets the prefix
// `the_`.
#include "emit/glsl/names.h"

#include <gtest/gtest.h>

namespace gliftc::test {
namespace {

TEST(GlslNames, TakenOnesAreNumbered) {
    glsl::Scopes scopes;
    EXPECT_EQ(scopes.declare("height"), "height");
    EXPECT_EQ(scopes.declare("height"), "height_1");
    EXPECT_EQ(scopes.declare("sample"), "sample_1");  // a keyword
    EXPECT_EQ(scopes.declare("set"), "set_1");        // after a struct of this name, layout(set = 0) would not parse
}

TEST(GlslNames, ThatStayReservedWithANumberGetAnotherBeginning) {
    glsl::Scopes scopes;
    for (const char* name : {"optional", "atomic", "gl", "subgroup", "debugPrintf"}) {
        const std::string first = scopes.declare(name), second = scopes.declare(name);
        EXPECT_EQ(first, "the_" + std::string(name));
        EXPECT_EQ(second, "the_" + std::string(name) + "_1");
    }
}

}  // namespace
}  // namespace gliftc::test
