// `gliftc test`: translates each file's test blocks to a C++ program, builds it with the system's compiler, and runs
// it: every test on the host device and, unless --device is host, on another one.
#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/compile.h"
#include "driver/include_folders.h"
#include "driver/remembered_runs.h"
#include "driver/test_program.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <unistd.h>
#include <variant>
#include <vector>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs a test program. True if it exits with code 0. If a signal ends it, prints the test that was running as failed.
bool run_program(const Options& options, const std::string& program) {
    // Beside the program: the cache can be written, and TMPDIR may name no folder.
    const fs::path now = program + ".now." + std::to_string(getpid());
    setenv("GLIFT_TEST_NOW", now.c_str(), 1);
    std::vector<std::string> words{program};
    if (!options.test_filter.empty()) words.insert(words.end(), {"--filter", options.test_filter});
    if (!options.device.empty()) words.insert(words.end(), {"--device", options.device});
    words.insert(words.end(), {"--timeout", std::to_string(options.test_timeout)});
    const Ended ended = run_and_wait(words);
    const std::string test = text_of(now);
    std::error_code ignored;
    fs::remove(now, ignored);
    if (ended.signal == 0) return ended.code == 0;
    std::printf("FAIL  %s\n      ended by signal %d (%s); what follows it did not run\n",
                test.empty() ? "before the first test" : test.c_str(), ended.signal, strsignal(ended.signal));
    return false;
}

bool is_wanted(const Options& options, const cpp::TestName& test) {
    return test.title.find(options.test_filter) != std::string::npos;
}

/// Whether the program has a test that the options (--filter) ask for.
bool is_wanted(const Options& options, const std::vector<cpp::TestName>& tests) {
    return std::ranges::any_of(tests, [&](const cpp::TestName& test) { return is_wanted(options, test); });
}

void list(const Options& options, const Result& result) {
    for (const Output& output : result.outputs)
        for (const cpp::TestName& test : output.tests)
            if (is_wanted(options, test)) std::printf("%s (%s)\n", test.title.c_str(), test.place.c_str());
}

/// Says that there is no test to run, and returns the exit code: that of wrong usage if there is a filter, else done.
int nothing_to_run(const Options& options) {
    if (options.test_filter.empty()) {
        std::printf("no tests\n");
        return static_cast<int>(ExitCode::done);
    }
    std::fprintf(stderr, "gliftc: no test has '%s' in its title; --list prints the titles\n",
                 options.test_filter.c_str());
    return static_cast<int>(ExitCode::wrong_usage);
}

/// All outputs that come from the same .glift file.
std::vector<Output> sources_of(const Output& output, const Result& result) {
    const std::string stem = output.name.substr(0, output.name.rfind(".glift.") + 7);
    std::vector<Output> sources;
    for (const Output& each : result.outputs)
        if (each.name.starts_with(stem)) sources.push_back(each);
    return sources;
}

/// Compiles the modules and builds the programs that have wanted tests. Returns all programs, or the exit code after
/// errors.
std::variant<std::vector<TestProgram>, int> build_programs(const Options& options, TestPrograms& built) {
    auto& compilation = *new Compilation;  // never destroyed: see run_compile
    configure(compilation.diagnostics, options);
    Questions questions;
    const Result result = compile(options, questions.noting(disk()), compilation);
    if (const int code = report(compilation, options); code != 0) return code;
    std::vector<TestProgram> programs;
    const std::vector<std::string> folders = include_folders(options, compilation);
    for (const Output& output : result.outputs) {
        if (output.tests.empty()) continue;
        const TestSources sources{sources_of(output, result), folders, compilation.read_files};
        programs.push_back({built.name_of(sources), output.tests});
        const std::string& name = programs.back().name;
        if (is_wanted(options, output.tests) && !built.has(name)) built.build(name, sources);
    }
    for (const std::string& file : compilation.read_files) questions.note_read(file);
    if (compilation.diagnostics.all().empty()) remember_run(built.record_of(options), questions, programs);
    return programs;
}

/// The programs of an earlier run with these options, if no file has changed since and the cache still has those with
/// wanted tests.
std::optional<std::vector<TestProgram>> programs_of_earlier_run(const Options& options, const TestPrograms& built) {
    if (std::ranges::find(options.files, "-") != options.files.end())
        return std::nullopt;  // standard input can be read only once
    std::optional<std::vector<TestProgram>> programs = recall_run(built.record_of(options), disk());
    if (!programs) return std::nullopt;
    for (const TestProgram& program : *programs)
        if (is_wanted(options, program.tests) && !built.has(program.name)) return std::nullopt;
    return programs;
}

int list_tests(const Options& options) {
    auto& compilation = *new Compilation;
    configure(compilation.diagnostics, options);
    const Result result = compile(options, disk(), compilation);
    if (const int code = report(compilation, options); code != 0) return code;
    if (std::ranges::none_of(result.outputs, [&](const Output& output) { return is_wanted(options, output.tests); }))
        return nothing_to_run(options);
    list(options, result);
    return static_cast<int>(ExitCode::done);
}

}  // namespace

int run_tests(const Options& given) {
    Options options = given;
    options.command = Command::test;
    options.targets = {Target::cpp, Target::host};
    options.host_only = options.device == "host";
    options.spirv_files = true;
    if (options.list_tests) return list_tests(options);
    TestPrograms built;
    std::optional<std::vector<TestProgram>> programs = programs_of_earlier_run(options, built);
    if (!programs) {
        auto made = build_programs(options, built);
        if (const int* code = std::get_if<int>(&made)) return *code;
        programs = std::get<std::vector<TestProgram>>(std::move(made));
    }
    std::erase_if(*programs, [&](const TestProgram& program) { return !is_wanted(options, program.tests); });
    if (programs->empty()) return nothing_to_run(options);
    if (options.validate) setenv("GLIFT_VALIDATE", "1", 0);
    setenv("GLIFT_POISON", "1", 0);
    bool passed = true;
    for (const TestProgram& program : *programs) passed &= run_program(options, built.use(program.name));
    return static_cast<int>(passed ? ExitCode::done : ExitCode::source_errors);
}

}  // namespace gliftc
