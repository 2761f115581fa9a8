// `gliftc test`: a file with its test blocks becomes a C++ program, which the system's compiler builds and which runs
// every test on the host device and on another.
#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/compile.h"
#include "driver/test_program.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs a program of tests. True if none failed; a test that ends the program has.
bool run_program(const Options& options, const std::string& program) {
    const fs::path now = fs::temp_directory_path() / ("gliftc-test-now." + std::to_string(getpid()));
    setenv("GLIFT_TEST_NOW", now.c_str(), 1);
    std::vector<std::string> words{program};
    if (!options.test_filter.empty()) words.insert(words.end(), {"--filter", options.test_filter});
    if (!options.device.empty()) words.insert(words.end(), {"--device", options.device});
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

/// The programs that have a test which the filter lets through.
std::vector<const Output*> programs_of(const Options& options, const Result& result) {
    std::vector<const Output*> programs;
    for (const Output& output : result.outputs)
        if (std::any_of(output.tests.begin(), output.tests.end(),
                        [&](const cpp::TestName& test) { return is_wanted(options, test); }))
            programs.push_back(&output);
    return programs;
}

void list(const Options& options, const Result& result) {
    for (const Output& output : result.outputs)
        for (const cpp::TestName& test : output.tests)
            if (is_wanted(options, test)) std::printf("%s (%s)\n", test.title.c_str(), test.place.c_str());
}

/// Where there is nothing to run: an error if that is not what was asked for.
int nothing_to_run(const Options& options) {
    if (options.test_filter.empty()) {
        std::printf("no tests\n");
        return static_cast<int>(ExitCode::done);
    }
    std::fprintf(stderr, "gliftc: no test has '%s' in its title; --list prints the titles\n",
                 options.test_filter.c_str());
    return static_cast<int>(ExitCode::wrong_usage);
}

/// All outputs of the file that one of them is of.
std::vector<Output> sources_of(const Output& output, const Result& result) {
    const std::string stem = output.name.substr(0, output.name.rfind(".glift.") + 7);
    std::vector<Output> sources;
    for (const Output& each : result.outputs)
        if (each.name.starts_with(stem)) sources.push_back(each);
    return sources;
}

/// Where headers of `extern struct` lie.
std::vector<std::string> include_folders(const Options& options) {
    std::vector<std::string> folders;
    for (const std::string& file : options.files) folders.push_back(fs::absolute(file).parent_path().string());
    for (const std::string& folder : options.import_folders) folders.push_back(fs::absolute(folder).string());
    return folders;
}

}  // namespace

int run_tests(const Options& given) {
    Options options = given;
    options.command = Command::test;
    options.targets = {Target::cpp, Target::host};
    options.host_only = options.device == "host";
    auto& compilation = *new Compilation;  // never taken down: see run_compile
    configure(compilation.diagnostics, options);
    const Result result = compile(options, disk(), compilation);
    if (const int code = report(compilation, options); code != 0) return code;
    const std::vector<const Output*> programs = programs_of(options, result);
    if (programs.empty()) return nothing_to_run(options);
    if (options.list_tests) {
        list(options, result);
        return static_cast<int>(ExitCode::done);
    }
    TestPrograms built;
    if (options.validate) setenv("GLIFT_VALIDATE", "1", 0);
    setenv("GLIFT_POISON", "1", 0);
    bool passed = true;
    for (const Output* output : programs)
        passed &= run_program(
            options, built.program(sources_of(*output, result), include_folders(options), compilation.read_files));
    return static_cast<int>(passed ? ExitCode::done : ExitCode::source_errors);
}

}  // namespace gliftc
