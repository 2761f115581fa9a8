#include "parse_text.h"

#include <gtest/gtest.h>

namespace gliftc::test {
namespace {

std::string errors(const std::string& text) { return Parsed("module m;\n" + text).errors(); }

TEST(Recovery, reports_independent_mistakes_in_one_run) {
    EXPECT_EQ(errors("fn f() {\n    let = 1;\n    let b = ;\n    for i of 0..4 { let x = ; }\n    c = d e;\n}\nkernel "
                     "k(a: ) { }\nconst d 1;\n"),
              "3:9 expected a name, found '='\n"
              "4:13 expected an expression, found ';'\n"
              "5:11 expected 'in', found 'of'\n"
              "6:11 expected ';', found 'e'\n"
              "8:13 expected a type, found ')'\n"
              "9:9 expected '=', found '1'\n");
}

TEST(Recovery, takes_a_missing_semicolon_as_written) {
    EXPECT_EQ(errors("fn f() {\n    let a = 1\n    let b = 2\n    return a + b\n}\n"),
              "3:14 expected ';', found 'let'\n4:14 expected ';', found 'return'\n5:17 expected ';', found '}'\n");
}

TEST(Recovery, points_at_the_brace_that_is_never_closed) {
    EXPECT_EQ(errors("fn f() {\n    if a {\n        b();\n}\n\nfn g() { }\n"), "2:8 '{' is never closed\n");
    EXPECT_EQ(errors("structure S() {\n    memory a = buffer<float>[1];\n\nkernel k() { }\n"),
              "2:15 '{' is never closed\n");
}

TEST(Recovery, says_which_brace_the_indentation_blames) {
    Parsed parsed("module m;\nfn f() {\n    if a {\n        b();\n}\n");
    ASSERT_EQ(parsed.diagnostics.all().size(), 1u);
    EXPECT_EQ(parsed.sources.position(parsed.diagnostics.all()[0].notes.back().span).line, 3u);
}

TEST(Recovery, skips_what_it_cannot_read_between_declarations) {
    EXPECT_EQ(errors("hello world { let x = 1; }\nfn f() { }\n} }\nfn g() { let = 2; }\n"),
              "2:1 expected a declaration, found 'hello'\n4:1 expected a declaration, found '}'\n5:14 expected a name, "
              "found '='\n");
}

TEST(Recovery, refuses_deep_nesting_once) {
    EXPECT_EQ(errors("const a = " + std::string(100000, '(') + ";\n"), "2:266 nested too deeply\n");
    std::string blocks(100000, '{');
    EXPECT_EQ(Parsed("module m; fn f() " + blocks).diagnostics.error_count(), 1u);
    std::string sum = "const a = 1";
    for (int i = 0; i < 100000; ++i) sum += " + 1";
    EXPECT_EQ(Parsed("module m;\n" + sum + ";").diagnostics.error_count(), 1u);
}

TEST(Recovery, stops_at_the_error_limit) {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += "const = 1;\n";
    EXPECT_EQ(Parsed("module m;\n" + text).diagnostics.error_count(), 50u);
}

TEST(Recovery, explains_what_other_languages_have) {
    Parsed increment("module m; fn f() { i++; }");
    ASSERT_EQ(increment.diagnostics.all().size(), 1u);
    EXPECT_EQ(increment.diagnostics.all()[0].notes.at(0).text, "there is no '++' and no '--': write 'i += 1'");
    Parsed loop("module m; fn f() { for (int i = 0; i < n; ++i) { } }");
    ASSERT_EQ(loop.diagnostics.all().size(), 1u) << loop.errors();
    EXPECT_EQ(loop.diagnostics.all()[0].notes.at(0).text, "loops are written 'for i in 0..n { }'");
}

TEST(Recovery, survives_every_prefix_and_every_lost_token) {
    const std::string text =
        "module m;\n/// doc\npub kernel k<N: uint>(f: in near<A<vec<2, float>>, 1>, g: out each<S>) group(4) {\n"
        "    if let v = f[+unit(1)] ?? x { g = {1, a: v ? 2 : 3}; } else { g[0..2].x <<= A<2>(1.5e3); }\n}\n"
        "structure S(n: uint) { memory m = image2d<float>(n) filter linear; if n > 1 { via A then B; } }\n";
    for (std::size_t end = 0; end < text.size(); ++end) {
        Parsed prefix(text.substr(0, end));
        render_text(prefix.diagnostics, prefix.sources, Colour::plain);
        Parsed without(text.substr(0, end) + text.substr(end + 1));
        render_text(without.diagnostics, without.sources, Colour::coloured);
    }
}

TEST(Lexer, reports_a_run_of_bad_characters_once) {
    EXPECT_EQ(errors("const a = 1 $$$ + 2;\n"), "2:13 unexpected character '$'\n");
    EXPECT_EQ(errors("const \xc3\xa9t\xc3\xa9 = 1 \xc3\x97 2;\nconst b = 1;\n"),
              "2:7 unexpected character '\xc3\xa9'\n2:15 unexpected character '\xc3\x97'\n");
}

TEST(Lexer, counts_columns_in_characters) {
    EXPECT_EQ(errors("/* \xe2\x82\xac\xe2\x82\xac */ const = 1;\n"), "2:16 expected a name, found '='\n");
}

}  // namespace
}  // namespace gliftc::test
