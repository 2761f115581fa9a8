#include "lowered.h"

#include <gmock/gmock.h>

namespace gliftc {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string checked(const std::string& kernel) {
    const Lowering lowering(kernel, lower::Checks::ranges);
    const std::string text = lowering.direct("k");
    EXPECT_EQ(lowering.forms("k").direct.has_reports, count(text, "report(") > 0) << text;
    // Without checks no reports are generated.
    EXPECT_THAT(Lowering(kernel).direct("k"), Not(HasSubstr("report(")));
    return text;
}

TEST(Checks, ReadsByAddress) {
    const std::string text = checked("kernel k(a: at<Field>, f: in any<Field>, g: out each<Field>) { g = f[a * 2u]; }");
    EXPECT_THAT(text, HasSubstr("if !f_value_inside {"));
    EXPECT_THAT(text, HasSubstr("report(f_data, f_address);"));
}

TEST(Checks, WritesByAddress) {
    const std::string text =
        checked("kernel k(f: in each<Field>, a: at<Field>, g: out scatter<Field>) { g[a * 2u] = f; }");
    EXPECT_THAT(text, HasSubstr("report(g_data, g_address);"));
    EXPECT_THAT(text, HasSubstr("binding g_data: buffer<float> write"));
}

TEST(Checks, NotWhereTheTranslatorDecides) {
    EXPECT_THAT(checked("kernel k(a: at<Field>, f: in any<Edged>, g: out each<Field>) { g = f[a * 2u]; }"),
                Not(HasSubstr("report(")));
    EXPECT_THAT(checked("kernel k(a: at<Field>, f: in any<Sparse>, g: out each<Field>) { g = f[a * 2u]; }"),
                Not(HasSubstr("report(")));
}

TEST(Checks, NotWhereTheKernelAsks) {
    EXPECT_THAT(checked("kernel k(f: in near<Field, 1>, g: out each<Field>) { g = f[int3(1, 0, 0)]; }"),
                Not(HasSubstr("report(")));
    EXPECT_THAT(checked("kernel k(a: at<Field>, f: in any<Field>, g: out each<Field>) { g = f.find(a * 2u) ?? 0.0; }"),
                Not(HasSubstr("report(")));
}

TEST(Checks, KnowTheFilesOfTheirKernel) {
    const Lowering lowering("kernel k(a: at<Field>, f: in any<Field>, g: out each<Field>) { g = f[a * 2u]; }",
                            lower::Checks::ranges);
    EXPECT_EQ(lowering.forms("k").direct.files.size(), 1u);
    EXPECT_EQ(lowering.forms("k").general.files, lowering.forms("k").direct.files);
}

}  // namespace
}  // namespace gliftc
