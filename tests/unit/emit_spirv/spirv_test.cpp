#include "emit/spirv/emit.h"
#include "emit/spirv/strip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <spirv-tools/libspirv.hpp>

#include <thread>

namespace gliftc::spirv {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string disassembled(const std::vector<std::uint32_t>& words) {
    std::string text;
    spvtools::SpirvTools(SPV_ENV_VULKAN_1_3).Disassemble(words, &text);
    return text;
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
}

const std::string head = "#version 460\n#extension GL_EXT_scalar_block_layout : require\n"
                         "#extension GL_GOOGLE_cpp_style_line_directive : require\nlayout(local_size_x = 64) in;\n"
                         "layout(scalar, set = 0, binding = 1) buffer F { vec3 f[]; };\n";

TEST(Spirv, ContractsFloatArithmeticOnRequest) {
    const Spirv made = spirv_of(head + "void main() { f[0] = f[1] * f[2] + min(f[3], f[4]); }\n", Optimise::no,
                                Stage::compute, Contraction::on);
    ASSERT_EQ(made.error, "");
    const std::string text = disassembled(made.words);
    EXPECT_EQ(count(text, " NoContraction"), 0u);
    EXPECT_THAT(text, HasSubstr("NMin"));
}

TEST(Spirv, NeverContractsFloatArithmetic) {
    Spirv made = spirv_of(
        head + "void main() { uint i = gl_GlobalInvocationID.x; f[i] = f[i] * f[i] + f[i] / 3.0 - (-f[i]); }\n");
    ASSERT_EQ(made.error, "");
    // The five operations *, +, /, - and unary -.
    EXPECT_EQ(count(disassembled(made.words), " NoContraction"), 5u);
}

TEST(Spirv, DefinesMinAndMaxForNotANumber) {
    Spirv made = spirv_of(head + "void main() { f[0] = clamp(min(f[1], f[2]), max(f[3], f[4]), f[5]); }\n");
    ASSERT_EQ(made.error, "");
    std::string text = disassembled(made.words);
    for (const char* word : {"NMin", "NMax", "NClamp"}) EXPECT_THAT(text, HasSubstr(word));
    for (const char* word : {" FMin", " FMax", " FClamp"}) EXPECT_THAT(text, Not(HasSubstr(word)));
}

TEST(Spirv, KeepsExactnessThroughTheOptimiser) {
    Spirv made = spirv_of(head + "void main() { uint i = gl_GlobalInvocationID.x; f[i] = f[i] * f[i] + f[i]; }\n",
                          Optimise::size);
    ASSERT_EQ(made.error, "");
    EXPECT_EQ(count(disassembled(made.words), " NoContraction"), 2u);
}

TEST(Spirv, ModulesWithoutDebugInfoAreTheSameCode) {
    const Spirv made =
        spirv_of(head + "#line 7 \"f.glift\"\nvoid main() { uint i = gl_GlobalInvocationID.x; f[i] += f[0]; }\n");
    ASSERT_EQ(made.error, "");
    const std::vector<std::uint32_t> words = without_debug_info(made.words);
    const std::string before = disassembled(made.words), after = disassembled(words);
    for (const char* op : {"OpSource", "OpName", "OpMemberName", "OpString", "OpLine"}) {
        EXPECT_THAT(before, HasSubstr(op));
        EXPECT_THAT(after, Not(HasSubstr(op)));
    }
    for (const char* op : {"OpEntryPoint", "OpDecorate", "OpLoad", "OpStore", "OpFAdd"})
        EXPECT_EQ(count(after, op), count(before, op)) << op;
    spvtools::ValidatorOptions options;
    options.SetScalarBlockLayout(true);
    EXPECT_TRUE(spvtools::SpirvTools(SPV_ENV_VULKAN_1_3).Validate(words.data(), words.size(), options));
}

TEST(Spirv, OptimisationForSizeMakesModulesSmaller) {
    const std::string source =
        head +
        "void main() { uint i = gl_GlobalInvocationID.x; vec3 x = f[i]; vec3 unused = f[i + 1]; f[i] = x + x; }\n";
    const Spirv plain = spirv_of(source), small = spirv_of(source, Optimise::size);
    ASSERT_EQ(plain.error + small.error, "");
    EXPECT_LT(without_debug_info(small.words).size(), without_debug_info(plain.words).size());
}

TEST(Spirv, StatesTheAlignmentOfScalarsForPartsOfStructsAtAnAddress) {
    const std::string reference =
        "#extension GL_EXT_buffer_reference : require\n"
        "#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require\n"
        "struct S { ivec4 a; bool b; vec4 c; dvec2 d; };\n"
        "layout(buffer_reference, scalar, buffer_reference_align = 8) buffer R { S at; };\n"
        "layout(buffer_reference, scalar, buffer_reference_align = 16) buffer Row { vec4 at; };\n"
        "layout(scalar, set = 0, binding = 2) buffer P { uint64_t address; };\n";
    Spirv made = spirv_of(head + reference +
                          "void main() {\n    S s = R(address).at;\n    s.b = !s.b;\n    R(address + 64ul).at = s;\n"
                          "    Row(address).at = Row(address + 16ul).at;\n}\n");
    ASSERT_EQ(made.error, "");
    const std::string text = disassembled(made.words);
    EXPECT_THAT(text, HasSubstr("v4int"));
    for (const char* wrong : {"Aligned 0", "Aligned 20", "Aligned 1\n"}) EXPECT_THAT(text, Not(HasSubstr(wrong)));
    EXPECT_EQ(count(text, "Aligned 16"), 2u) << "the rows\n" << text;
    EXPECT_GE(count(text, "Aligned 4"), 3u) << text;
}

TEST(Spirv, KeepsLinesButNotTheTextOfTheGlsl) {
    Spirv made = spirv_of(head + "void main() {\n#line 9 \"laplacian.glift\"\n    f[0] = f[1];\n}\n");
    ASSERT_EQ(made.error, "");
    std::string text = disassembled(made.words);
    EXPECT_THAT(text, HasSubstr("OpSource GLSL 460"));
    EXPECT_THAT(text, HasSubstr("\"laplacian.glift\""));
    EXPECT_THAT(text, HasSubstr("OpLine"));
    EXPECT_THAT(text, Not(HasSubstr("#version")));
    EXPECT_THAT(text, Not(HasSubstr("void main()")));
}

TEST(Spirv, NamesTheSourceLineInErrors) {
    Spirv made = spirv_of(head + "void main() {\n#line 9 \"laplacian.glift\"\n    f[0] = undeclared;\n}\n");
    EXPECT_TRUE(made.words.empty());
    EXPECT_THAT(made.error, HasSubstr("laplacian.glift:9: "));
    EXPECT_THAT(made.error, HasSubstr("undeclared"));
}

TEST(Spirv, KeepsNamesAndLines) {
    Spirv made =
        spirv_of(head + "void main() {\n#line 9 \"laplacian.glift\"\n    float sum = f[0].x;\n    f[1].x = sum;\n}\n");
    ASSERT_EQ(made.error, "");
    std::string text = disassembled(made.words);
    EXPECT_THAT(text, HasSubstr("\"sum\""));
    EXPECT_THAT(text, HasSubstr("OpString \"laplacian.glift\""));
    EXPECT_THAT(text, HasSubstr(" 9 0"));
}

TEST(Spirv, IsTheSameEachTimeAndFromSeveralThreads) {
    const std::string glsl = head + "void main() { f[0] = f[1] * 2.0; }\n";
    const Spirv first = spirv_of(glsl);
    std::vector<Spirv> made(4);
    std::vector<std::thread> threads;
    for (Spirv& one : made) threads.emplace_back([&] { one = spirv_of(glsl); });
    for (std::thread& thread : threads) thread.join();
    for (const Spirv& one : made) EXPECT_EQ(one.words, first.words);
}

}  // namespace
}  // namespace gliftc::spirv
