// For every golden case: the output of gliftc is equal to the stored files, glslang accepts the GLSL and spirv-val the
// SPIR-V made of it, and the C++ compiles. Nothing here writes golden files: tools/bless does.

#include "golden.h"

#include "support/process.h"

#include <gtest/gtest.h>

namespace glift::test {
namespace {

class Golden : public testing::TestWithParam<std::filesystem::path> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Golden);

/// The first line in which two texts differ, for a short report.
std::string first_difference(const std::string& expected, const std::string& actual) {
    std::size_t line = 1, start = 0;
    for (std::size_t i = 0; i < expected.size() && i < actual.size() && expected[i] == actual[i]; ++i) {
        if (expected[i] != '\n') continue;
        ++line;
        start = i + 1;
    }
    const auto line_at = [start](const std::string& text) {
        return start < text.size() ? text.substr(start, text.find('\n', start) - start) : std::string("(end of file)");
    };
    return "line " + std::to_string(line) + "\n  expected: " + line_at(expected) + "\n  now:      " + line_at(actual);
}

TEST_P(Golden, is_as_expected) {
    const TemporaryFolder folder;
    const GoldenOutputs now = compile_golden(GetParam(), folder.path());
    ASSERT_EQ(now.error, "");
    const auto stored = stored_goldens(GetParam());
    for (const auto& [name, text] : now.files) {
        const auto expected = stored.find(name);
        if (expected == stored.end()) {
            ADD_FAILURE() << name << " is not stored (tools/bless writes it)";
        } else if (expected->second != text) {
            ADD_FAILURE() << name << " differs in " << first_difference(expected->second, text)
                          << "\n(if that is meant: tools/bless)";
        }
    }
    for (const auto& [name, text] : stored) {
        EXPECT_TRUE(now.files.contains(name)) << name << " is stored, but gliftc no longer makes it";
    }
}

TEST_P(Golden, glsl_passes_glslang_and_the_validator) {
    const TemporaryFolder folder;
    const ProcessResult run = run_process({GLIFT_GLIFTC, "--target=spirv", "-o", folder.path().string(), "-I",
                                           (GetParam().parent_path() / "support").string(), GetParam().string()});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    for (const std::filesystem::path& module : files_under(folder.path(), ".spv")) {
        const ProcessResult validator =
            run_process({"spirv-val", "--target-env", "vulkan1.3", "--scalar-block-layout", module.string()});
        EXPECT_EQ(validator.exit_code, 0) << module.filename() << ": " << validator.err << validator.out;
    }
}

TEST_P(Golden, cpp_compiles) {
    const TemporaryFolder folder;
    const ProcessResult run = run_process({GLIFT_GLIFTC, "--target=cpp", "--target=host", "-o", folder.path().string(),
                                           "-I", (GetParam().parent_path() / "support").string(), GetParam().string()});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto sources = files_under(folder.path(), ".cpp");
    EXPECT_FALSE(sources.empty());
    for (const std::filesystem::path& source : sources) {
        const ProcessResult compiler =
            run_process({"g++", "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-I",
                         GLIFT_SOURCE_DIR "/runtime/include", "-I", folder.path().string(), source.string()});
        EXPECT_EQ(compiler.exit_code, 0) << compiler.err;
    }
}

std::string case_name(const testing::TestParamInfo<std::filesystem::path>& info) {
    std::string name = std::filesystem::relative(info.param, GLIFT_SOURCE_DIR "/tests/golden").replace_extension();
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(, Golden, testing::ValuesIn(golden_cases()), case_name);

}  // namespace
}  // namespace glift::test
