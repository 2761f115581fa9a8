// Every file of tests/errors gives exactly the errors and warnings that its comments expect, and at least the notes
// (README.md there). Every id of a diagnostic has a file, and is expected.

#include "expectations.h"

#include "support/process.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace glift::test {
namespace {

const std::filesystem::path folder = GLIFT_SOURCE_DIR "/tests/errors";

class Errors : public testing::TestWithParam<std::filesystem::path> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Errors);

/// The elements of `these` that are not in `those`, as multisets.
std::vector<std::string> missing_from(const std::vector<Report>& those, const std::vector<Report>& these) {
    std::multiset<Report> left(those.begin(), those.end());
    std::vector<std::string> missing;
    for (const Report& report : these) {
        if (const auto found = left.find(report); found != left.end()) {
            left.erase(found);
        } else {
            missing.push_back(to_string(report));
        }
    }
    return missing;
}

TEST_P(Errors, are_reported_as_written) {
    const std::string text = read_file(GetParam());
    std::vector<std::string> command = {GLIFT_GLIFTC,    "--check", "--diagnostics-format=text",
                                        "--color=never", "-I",      (folder / "support").string()};
    for (const std::string& argument : extra_arguments(text)) command.push_back(argument);
    command.push_back(GetParam().string());
    const ProcessResult run = run_process(command);

    const std::vector<Report> expected = read_expectations(GetParam().filename().string(), text);
    const std::vector<Report> reported = read_diagnostics(run.err);
    std::vector<Report> reported_without_notes = reported;
    std::erase_if(reported_without_notes, [](const Report& report) { return report.severity == "note"; });
    for (const std::string& report : missing_from(reported, expected)) ADD_FAILURE() << "not reported: " << report;
    for (const std::string& report : missing_from(expected, reported_without_notes)) {
        ADD_FAILURE() << "reported, not expected: " << report;
    }
    const bool has_error =
        std::any_of(expected.begin(), expected.end(), [](const Report& report) { return report.severity == "error"; });
    EXPECT_EQ(run.exit_code, has_error ? 1 : 0) << run.err;
    if (HasFailure()) std::printf("gliftc said:\n%s\n", run.err.c_str());
}

std::string id_shown(std::string id) {
    std::replace(id.begin(), id.end(), '_', '-');
    return id;
}

TEST(ErrorTable, every_id_has_a_test_that_expects_it) {
    std::set<std::string> expected;
    for (const std::filesystem::path& file : files_under(folder, ".glift")) {
        for (const Report& report : read_expectations(file.filename().string(), read_file(file))) {
            expected.insert(report.id);
        }
    }
    const std::string ids[] = {
#define DIAGNOSTIC(name, severity, text) #name,
#include "diag/diagnostics.def"
#undef DIAGNOSTIC
    };
    for (const std::string& id : ids) {
        EXPECT_TRUE(std::filesystem::exists(folder / (id + ".glift"))) << "there is no tests/errors/" << id << ".glift";
        EXPECT_TRUE(expected.contains(id_shown(id))) << "no test expects [" << id_shown(id) << "]";
    }
}

std::string case_name(const testing::TestParamInfo<std::filesystem::path>& info) {
    std::string name = info.param.stem();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(, Errors, testing::ValuesIn(files_under(folder, ".glift")), case_name);

}  // namespace
}  // namespace glift::test
