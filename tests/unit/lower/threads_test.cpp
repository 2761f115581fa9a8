#include "lowered.h"

namespace gliftc {
namespace {

constexpr int kernels = 60;

/// The text of kernel number k. Each kernel is different, and lowering it adds new types and names to the program.
std::string kernel(int k) {
    const std::string n = std::to_string(k);
    const std::string rest = "fn rest" + n + "(s: Edged, a: uint3) -> float { var x" + n + " = 0.0; while x" + n +
                             " < s[a] { x" + n + " += s[a] * 2.0; } return x" + n + "; }\n";
    return rest + "kernel k" + n + "(f: in near<Field, 1>, s: in any<Edged>, g: out each<Field>) {\n    let sum" + n +
           " = f[0] + f[int3(1, 0, 0)] * " + n + ".0;\n    g = sum" + n + " * sum" + n + " + rest" + n +
           "(s, position());\n}\n";
}

TEST(Threads, LowerEachKernelAsIfItWereAlone) {
    std::string text;
    for (int k = 0; k < kernels; ++k) text += kernel(k);
    const Lowering all(text);
    for (int k = 0; k < kernels; k += 7) {
        const Lowering alone(kernel(k));
        const std::string name = "k" + std::to_string(k);
        EXPECT_EQ(all.direct(name), alone.direct(name));
        EXPECT_EQ(all.general(name), alone.general(name));
    }
}

TEST(Threads, MakeTheSameProgramEachTime) {
    std::string text;
    for (int k = 0; k < kernels; ++k) text += kernel(k);
    const Lowering first(text), second(text);
    EXPECT_EQ(ir::print(first.program, first.lowered), ir::print(second.program, second.lowered));
    EXPECT_EQ(first.program.exprs.size(), second.program.exprs.size());
    ASSERT_EQ(first.program.locals.size(), second.program.locals.size());
    for (std::uint32_t i = 0; i < first.program.locals.size(); ++i) {
        EXPECT_EQ(first.program.locals[{i}].name, second.program.locals[{i}].name);
        EXPECT_EQ(first.program.locals[{i}].type, second.program.locals[{i}].type);
    }
}

TEST(Threads, ReportInTheOrderOfTheKernels) {
    std::string text;
    for (int k = 0; k < kernels; ++k)
        text +=
            "kernel k" + std::to_string(k) + "(f: in near<Field, 1>, g: out each<Field>) { g = f[int3(2, 0, 0)]; }\n";
    Lowering lowering(text);
    const std::vector<Diagnostic>& found = lowering.diagnostics.all();
    EXPECT_EQ(found.size(), lowering.diagnostics.error_limit);
    for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LT(found[i - 1].span.begin, found[i].span.begin);
}

}  // namespace
}  // namespace gliftc
