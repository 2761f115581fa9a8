#include "lowered.h"

#include <gmock/gmock.h>

#include <array>

namespace gliftc {
namespace {

using testing::HasSubstr;
using testing::Not;

const ir::Variant& shader_variant(const ir::Pass& pass) { return variant_for(pass, ir::Devices::shaders); }

/// The number of elements that an invocation takes along each axis; both forms must have the same.
std::array<std::uint32_t, 3> taken(const Lowering& lowering) {
    const ir::Lowered::Forms& forms = lowering.forms("k");
    EXPECT_EQ(shader_variant(forms.general).assumes.elements, shader_variant(forms.direct).assumes.elements);
    return shader_variant(forms.direct).assumes.elements;
}

std::string pair_of(const Lowering& lowering) {
    const ir::Pass& pass = lowering.forms("k").direct;
    return ir::print(lowering.program, shader_variant(pass).body, &pass);
}

constexpr std::array one{1u, 1u, 1u}, a_row_each{1u, 2u, 1u};

std::array<std::uint32_t, 3> taken(const std::string& text, lower::Checks checks = lower::Checks::none) {
    return taken(Lowering(text, checks));
}

TEST(Coarsen, LoadsOfBothElementsComeBeforeTheFirstStore) {
    Lowering lowering("kernel k(f: in each<Field>, g: inout each<Field>) { g = g + f; }");
    EXPECT_EQ(taken(lowering), a_row_each);
    const std::string text = pair_of(lowering);
    EXPECT_EQ(count(text, "f_data["), 2u) << text;
    EXPECT_LT(text.rfind(": float = "), text.find("g_data[f_at] = ")) << text;
}

TEST(Coarsen, RowsShareWhatIsTheSameInBoth) {
    Lowering lowering(
        "kernel k(f: in near<Field, 1>, g: out each<Field>) { g = f[int3(1, 0, 0)] + f[int3(0, 0, 1)]; }");
    EXPECT_EQ(taken(lowering), a_row_each);
    const std::string text = pair_of(lowering);
    EXPECT_EQ(count(text, "address.x + 1u"), 1u) << text;
    EXPECT_EQ(count(text, "address.z + 1u"), 1u) << text;
}

TEST(Coarsen, AVariableThatChangesBetweenStoresIsKept) {
    Lowering lowering(
        "kernel k(f: in each<Field>, g: out each<Field>, h: out each<Field>) { var s = f; g = s; s += 1.0; h = s; }");
    EXPECT_EQ(taken(lowering), a_row_each);
    const std::string text = pair_of(lowering);
    EXPECT_THAT(text, HasSubstr("let g.2: float = s;"));
    EXPECT_THAT(text, Not(HasSubstr("g_data[f_at] = s;")));
}

TEST(Coarsen, OneElementWhereTwoWouldChangeWhatIsRead) {
    EXPECT_EQ(taken("kernel k(g: inout each<Field>, h: out each<Field>) { g = g + 1.0; h = g; }"), one);
}

TEST(Coarsen, OneElementWhereThereIsALoop) {
    EXPECT_EQ(taken("kernel k(f: in each<Field>, g: out each<Field>, n: uint) {"
                    "    var x = f; for i in 0..n { x = x * 0.5; } g = x; }"),
              one);
    EXPECT_EQ(taken("fn root(a: float) -> float { var x = a; while x * x > a { x = 0.5 * (x + a / x); } return x; }"
                    "kernel k(f: in each<Field>, g: out each<Field>) { g = root(f); }"),
              one);
}

TEST(Coarsen, TwoNamesOfOnePlaceAreReadInTurn) {
    Lowering lowering(
        "kernel k(f: in each<Field>, g: out each<Field>, h: out each<Field>) { g = f + 1.0; h = 2.0 * f; }");
    EXPECT_EQ(taken(lowering), a_row_each);  // the direct form assumes no aliases
    EXPECT_EQ(count(pair_of(lowering), "= f_data["), 2u) << pair_of(lowering);
    const ir::Pass& general = lowering.forms("k").general;
    const std::string text = ir::print(lowering.program, shader_variant(general).body, &general);
    const std::size_t store = text.find("g_data["), load = text.find("= f_data[", store);
    const std::size_t next = text.find("if has_next");
    EXPECT_LT(store, load) << text;
    EXPECT_LT(load, next) << text;
    EXPECT_EQ(count(text, "= f_data["), 4u) << text;
}

TEST(Coarsen, ConditionalStoresWaitToo) {
    Lowering lowering("kernel k(f: in each<Field>, g: inout each<Field>) { if g > 0.0 { g = f; } else { g = -f; } }");
    EXPECT_EQ(taken(lowering), a_row_each);
    const std::string text = pair_of(lowering);
    EXPECT_LT(text.find("let g_value.2"), text.find("if ")) << text;
    EXPECT_EQ(count(text, "if "), 2u) << text;
}

TEST(Coarsen, OneElementWhereStoresAddUp) {
    EXPECT_EQ(taken("kernel k(f: in each<Field>, g: out scatter<Field, add>) { g[position()] = f; }"), one);
}

TEST(Coarsen, ARowFurtherIsTheSecondElementItself) {
    Lowering lowering("kernel k(f: in near<Field, 1>, g: out each<Field>) {"
                      "    g = f[0] + f[int3(0, 1, 0)] + f[int3(0, -1, 0)]; }");
    EXPECT_EQ(taken(lowering), a_row_each);
    const std::string text = pair_of(lowering);
    EXPECT_EQ(count(text, "f_data["), 4u) << text;
    EXPECT_EQ(count(text, "if has_next"), 1u) << text;
    EXPECT_THAT(text, HasSubstr("(address.y + 2u) < $f_extent.y"));
}

/// A value that is loaded under a condition is not shared with the second element, for which the condition may not
/// hold.
TEST(Coarsen, ARowFurtherUnderAConditionIsNotShared) {
    Lowering lowering("kernel k(f: in near<Field, 1>, g: out each<Field>, s: float) {"
                      "    var sum = f[0]; if sum > s { sum += f[int3(0, 1, 0)]; } g = sum; }");
    EXPECT_EQ(taken(lowering), a_row_each);
    const std::string text = pair_of(lowering);
    EXPECT_EQ(count(text, "f_data["), 4u) << text;
    EXPECT_EQ(count(text, "if has_next"), 0u) << text;
}

TEST(Coarsen, OneElementInGroups) {
    EXPECT_EQ(taken("kernel k(f: in each<Field>, g: out each<Field>) group(8, 4, 2) { g = f; }"), one);
}

TEST(Coarsen, OneElementWhereAccessesAreChecked) {
    EXPECT_EQ(taken("kernel k(a: at<Field>, f: in any<Field>, g: out each<Field>) { g = f[a]; }", lower::Checks::none),
              a_row_each);
    EXPECT_EQ(
        taken("kernel k(a: at<Field>, f: in any<Field>, g: out each<Field>) { g = f[a]; }", lower::Checks::ranges),
        one);
}

TEST(Coarsen, OneElementThatIsWorkEnough) {
    std::string sum = "0.0";
    for (int i = 0; i < 9; ++i)
        sum += " + f[int3(" + std::to_string(i - 4) + ", 0, 0)] * f[int3(0, 1, " + std::to_string(i - 4) + ")]";
    EXPECT_EQ(taken("kernel k(f: in near<Field, 4>, g: out each<Field>) { g = " + sum + "; }"), one);
}

/// The general form has more to compute and may exceed the limit when the direct form does not; all forms of a kernel
/// must still take the same number of elements.
TEST(Coarsen, AllFormsTakeAsMany) {
    const auto kernel_of = [](int steps) {
        std::string text = "kernel k(f: in near<Field, 1>, g: out each<Field>) { var x = f[int3(0, 1, 0)];";
        for (int i = 0; i < steps; ++i) text += " x = x * 0.5 + float(position().x + " + std::to_string(i) + "u);";
        return text + " g = x; }";
    };
    EXPECT_EQ(taken(kernel_of(1)), a_row_each);
    int last = 0;
    for (int steps = 62; steps <= 74; ++steps)
        if (taken(kernel_of(steps)) == a_row_each) last = steps;
    EXPECT_GT(last, 62);
    EXPECT_LT(last, 74);
}

}  // namespace
}  // namespace gliftc
