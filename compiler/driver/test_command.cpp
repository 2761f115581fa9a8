// `gliftc test`: a file with its test blocks becomes a C++ program, which the system's compiler builds and which runs
// every test on the host device and on another.
#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/compile.h"
#include "driver/environment.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

/// The runtime beside this executable: ../include and ../lib, in a build tree as in an installed one.
struct RuntimePaths {
    fs::path include, library;
};

RuntimePaths find_runtime() {
    const fs::path root = fs::canonical("/proc/self/exe").parent_path().parent_path();
    RuntimePaths paths{root / "include", {}};
    if (!fs::exists(paths.include / "glift" / "testing.h"))
        throw EnvironmentError("no glift/testing.h in " + paths.include.string());
    for (const char* folder : {"lib", "lib64", "lib/x86_64-linux-gnu", "lib/aarch64-linux-gnu"}) {
        if (fs::exists(root / folder / "libglift.so") || fs::exists(root / folder / "libglift.a"))
            paths.library = root / folder;
    }
    if (paths.library.empty()) throw EnvironmentError("no libglift in " + (root / "lib").string());
    return paths;
}

/// A folder that goes with its contents when the tests are over.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (fs::temp_directory_path() / "gliftc-test-XXXXXX").string();
        if (!mkdtemp(pattern.data()))
            throw EnvironmentError("cannot make a folder in " + fs::temp_directory_path().string());
        path_ = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// How a program ended.
struct Ended {
    int code = 0;
    int signal = 0;  ///< that ended it; 0: it ended by itself
};

constexpr int cannot_run = 127;

/// Runs a program with this one's input and outputs.
Ended run(const std::vector<std::string>& words) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw EnvironmentError("cannot start " + words[0]);
    if (child == 0) {
        execvp(arguments[0], arguments.data());
        _exit(cannot_run);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status)) return {WEXITSTATUS(status), 0};
    return {1, WTERMSIG(status)};
}

std::vector<std::string> compiler_command() {
    std::vector<std::string> words;
    const char* chosen = std::getenv("CXX");
    std::string text = chosen && *chosen ? chosen : "c++";
    std::size_t begin = 0;
    while (begin < text.size()) {  // CXX may hold a launcher: "ccache g++"
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        if (end > begin) words.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

/// Builds the program that one generated source is. Returns its path.
std::string build(const Options& options, const RuntimePaths& runtime, const fs::path& source) {
    const std::string program = fs::path(source).replace_extension().string();
    std::vector<std::string> words = compiler_command();
    const std::string compiler = words[0], library = runtime.library.string();
    // -Og: less to wait for than with -O1, and good to step through. One copy of a kernel, not one a width of vectors.
    for (const std::string& word :
         {std::string("-std=c++20"), std::string("-Og"), std::string("-DGLIFT_HOST_KERNEL="),
          std::string("-ffp-contract=off"), std::string("-fwrapv"), std::string("-fno-math-errno"),
          std::string("-fno-trapping-math"), "-I" + runtime.include.string(), "-I" + source.parent_path().string(),
          source.string(), "-L" + library, "-Wl,-rpath," + library, std::string("-lglift"), std::string("-ltbb"),
          std::string("-o"), program})
        words.push_back(word);
    for (const std::string& file : options.files)
        words.insert(words.end() - 2, "-I" + fs::absolute(file).parent_path().string());
    const Ended ended = run(words);
    if (ended.code == cannot_run)
        throw EnvironmentError("'gliftc test' builds tests with a C++ compiler, and there is no '" + compiler +
                               "' here: install one (Debian: g++), or name one in CXX");
    if (ended.code != 0)
        throw std::runtime_error("the C++ compiler refused what gliftc wrote for " + source.stem().string());
    return program;
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs a program of tests. True if none failed; a test that ends the program has.
bool run_program(const Options& options, const std::string& program) {
    const fs::path now = program + ".now";
    setenv("GLIFT_TEST_NOW", now.c_str(), 1);
    std::vector<std::string> words{program};
    if (!options.test_filter.empty()) words.insert(words.end(), {"--filter", options.test_filter});
    if (!options.device.empty()) words.insert(words.end(), {"--device", options.device});
    const Ended ended = run(words);
    if (ended.signal == 0) return ended.code == 0;
    const std::string test = text_of(now);
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

void write(const fs::path& folder, const Result& result) {
    for (const Output& output : result.outputs)
        if (auto error = write_if_changed((folder / output.name).string(), output.bytes))
            throw EnvironmentError("cannot write " + (folder / output.name).string() + ": " + *error);
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
    const RuntimePaths runtime = find_runtime();
    const TemporaryFolder folder;
    write(folder.path(), result);
    if (options.validate) setenv("GLIFT_VALIDATE", "1", 0);
    setenv("GLIFT_POISON", "1", 0);
    bool passed = true;
    for (const Output* output : programs)
        passed &= run_program(options, build(options, runtime, folder.path() / output->name));
    return static_cast<int>(passed ? ExitCode::done : ExitCode::source_errors);
}

}  // namespace gliftc
