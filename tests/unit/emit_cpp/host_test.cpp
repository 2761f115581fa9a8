// What the printer writes for kernels that run over rows, for names and for long lines. Tests on devices show that the
// code is right (tests/device and `gliftc test`).
#include "builder.h"

#include "emit/cpp/host/emit.h"
#include "emit/cpp/kernel_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace gliftc;
using testing::HasSubstr;
using testing::Not;

TEST(HostKernel, RunsInsideThroughPointersToTheRow) {
    test::Builder b;
    const ir::Pass pass = test::heat_pass(b);
    const cpp::ProgramNames names = cpp::program_names(b.program);
    cpp::Globals globals = cpp::make_globals(b.program, b.sources, names, {{0}, {0}});
    const std::string text = host::kernel_of(globals, pass, "heat_direct");
    EXPECT_THAT(text, HasSubstr("glift::host::interior_of(row, uint3(), f_extent, 1)"));
    EXPECT_THAT(text, HasSubstr("const float* f_data_row = glift::host::row_pointer(f_data + f_index);"));
    EXPECT_THAT(text, HasSubstr("g_data_row[i] = f_data_row[i] + k * sum;"));
    EXPECT_THAT(text, HasSubstr("static void heat_direct(const glift::HostCall& call)"));
    EXPECT_THAT(text, Not(HasSubstr("not lowered")));
    EXPECT_THAT(cpp::parameters_of(globals, pass, "heat_direct"),
                HasSubstr("static_assert(sizeof(heat_direct_parameters) == 16);"));
}

TEST(Names, StayOutOfTheWayOfCpp) {
    EXPECT_EQ(cpp::identifier("Array<4, float>"), "Array_4_float");
    EXPECT_EQ(cpp::identifier("float4"), "float4_");
    EXPECT_EQ(cpp::identifier("2d"), "n2d");
    cpp::Scopes scopes;
    EXPECT_EQ(scopes.declare("sum"), "sum");
    scopes.enter();
    EXPECT_EQ(scopes.declare("sum"), "sum_2");
    scopes.leave();
    EXPECT_EQ(scopes.declare("sum"), "sum_2");
}

TEST(Writer, BreaksLongLinesAtTheOutermostComma) {
    cpp::Writer out;
    out.open("void f()");
    out.line("call(" + std::string(60, 'a') + ", inner(" + std::string(30, 'b') + ", " + std::string(30, 'c') + "));");
    out.close();
    EXPECT_THAT(out.text(), HasSubstr("a,\n        inner("));
}
