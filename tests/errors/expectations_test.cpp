// Tests the runner of the error tests: it must read all expectations and diagnostics, and no others.

#include "expectations.h"

#include <gtest/gtest.h>

namespace glift::test {
namespace {

TEST(Expectations, carets_speak_of_the_last_line_of_code) {
    const auto found = read_expectations("a.glift", "let x = yy;\n"
                                                    "//~     ^^ error: unknown name 'yy' [unknown-name]\n"
                                                    "//~ @7:2-3 warning: w [some-id]\n"
                                                    "//~ nowhere error: e [other-id]\n");
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(to_string(found[0]), "a.glift:1:9-10 error: unknown name 'yy' [unknown-name]");
    EXPECT_EQ(to_string(found[1]), "a.glift:7:2-3 warning: w [some-id]");
    EXPECT_EQ(to_string(found[2]), "nowhere error: e [other-id]");
}

TEST(Expectations, printed_diagnostics_have_the_extent_of_their_carets) {
    const auto found = read_diagnostics("/some/a.glift:1:9: error: unknown name 'yy' [unknown-name]\n"
                                        "let x = yy;\n"
                                        "        ^~\n"
                                        "/some/a.glift:3:1: note: did you mean 'y'?\n"
                                        "gliftc: error: cannot read 'b' [cannot-read]\n");
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(to_string(found[0]), "a.glift:1:9-10 error: unknown name 'yy' [unknown-name]");
    EXPECT_EQ(to_string(found[1]), "a.glift:3:1-1 note: did you mean 'y'?");
    EXPECT_EQ(to_string(found[2]), "nowhere error: cannot read 'b' [cannot-read]");
}

TEST(Expectations, arguments_stand_on_the_first_line) {
    EXPECT_EQ(extra_arguments("// gliftc: -D a=1 -Werror\nmodule m;\n"),
              (std::vector<std::string>{"-D", "a=1", "-Werror"}));
    EXPECT_TRUE(extra_arguments("module m;\n// gliftc: -D a=1\n").empty());
}

}  // namespace
}  // namespace glift::test
