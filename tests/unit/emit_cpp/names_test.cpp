#include "emit/cpp/names.h"

#include <gtest/gtest.h>

namespace gliftc::cpp {
namespace {

// M_PI_2 is a macro of <math.h>.
TEST(Scopes, numbered_names_are_no_macros) {
    Scopes scopes;
    EXPECT_EQ(scopes.declare("M_PI"), "M_PI_");
    EXPECT_EQ(scopes.declare("M_PI"), "M_PI_3");
}

}  // namespace
}  // namespace gliftc::cpp
