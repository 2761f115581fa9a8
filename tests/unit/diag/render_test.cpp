#include "diag/render.h"

#include <gtest/gtest.h>

namespace gliftc {
namespace {

TEST(Render, puts_carets_under_the_exact_words) {
    Sources sources;
    Diagnostics diagnostics;
    auto file = sources.add("a.glift", "\tlet \xc3\xa9t\xc3\xa9 = wrong; // x\n");
    auto& error = diagnostics.report(Diag::unknown_name, {file, 13, 18}, {"wrong"});
    error.notes.push_back({{}, "did you mean 'wring'?"});
    error.notes.push_back({{file, 1, 4}, "here"});
    EXPECT_EQ(render_text(diagnostics, sources, Colour::plain),
              "a.glift:1:12: error: unknown name 'wrong' [unknown-name]\n"
              "    \tlet \xc3\xa9t\xc3\xa9 = wrong; // x\n"
              "    \t          ^~~~~\n"
              "note: did you mean 'wring'?\n"
              "a.glift:1:2: note: here\n"
              "    \tlet \xc3\xa9t\xc3\xa9 = wrong; // x\n"
              "    \t^~~\n");
}

TEST(Render, writes_json) {
    Sources sources;
    Diagnostics diagnostics;
    auto file = sources.add("a \"b\".glift", "x\ny\n");
    diagnostics.report(Diag::unknown_name, {file, 2, 3}, {"y\n"});
    EXPECT_EQ(render_json(diagnostics, sources),
              "[\n  {\"severity\": \"error\", \"id\": \"unknown-name\", \"text\": \"unknown name 'y\\n'\", \"file\": "
              "\"a \\\"b\\\".glift\", "
              "\"line\": 2, \"column\": 1, \"end_line\": 2, \"end_column\": 2, \"notes\": []}\n]\n");
}

TEST(Diagnostics, keep_one_error_a_place) {
    Sources sources;
    Diagnostics diagnostics;
    auto file = sources.add("a.glift", "abc");
    diagnostics.report(Diag::unknown_name, {file, 0, 3}, {"abc"});
    diagnostics.report(Diag::bad_number, {file, 0, 3}, {"abc"});
    diagnostics.report(Diag::bad_number, {file, 0, 2}, {"ab"});
    EXPECT_EQ(diagnostics.all().size(), 2u);
}

TEST(Diagnostics, leave_out_or_promote_warnings) {
    Diagnostics diagnostics;
    diagnostics.silenced = {Diag::unused_variable};
    diagnostics.report(Diag::unused_variable, {}, {"a"});
    EXPECT_TRUE(diagnostics.all().empty());
    diagnostics.silenced = {};
    diagnostics.promoted = {Diag::unused_variable};
    diagnostics.report(Diag::unused_variable, {}, {"b"});
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_TRUE(diagnostics.has_errors());
}

TEST(DidYouMean, finds_the_nearest) {
    EXPECT_EQ(did_you_mean("lenght", {"height", "length", "len"}), "length");
    EXPECT_EQ(did_you_mean("kernal", {"kernel", "kernels"}), "kernel");
    EXPECT_EQ(did_you_mean("x", {"quite_another"}), "");
    EXPECT_EQ(did_you_mean("extent", {"offset"}), "");
}

}  // namespace
}  // namespace gliftc
