// `gliftc test`: a file with its test blocks becomes a C++ program, which the system's compiler builds and which runs
// every test on the host device and on another.
#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/compile.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
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
        throw std::runtime_error("no glift/testing.h in " + paths.include.string());
    for (const char* folder : {"lib", "lib64", "lib/x86_64-linux-gnu", "lib/aarch64-linux-gnu"}) {
        if (fs::exists(root / folder / "libglift.so") || fs::exists(root / folder / "libglift.a"))
            paths.library = root / folder;
    }
    if (paths.library.empty()) throw std::runtime_error("no libglift in " + (root / "lib").string());
    return paths;
}

/// A folder that goes with its contents when the tests are over.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (fs::temp_directory_path() / "gliftc-test-XXXXXX").string();
        if (!mkdtemp(pattern.data()))
            throw std::runtime_error("cannot make a folder in " + fs::temp_directory_path().string());
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

/// Runs a program with this one's input and outputs; its exit code, or 1 where it was killed.
int run(const std::vector<std::string>& words) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot start " + words[0]);
    if (child == 0) {
        execvp(arguments[0], arguments.data());
        std::fprintf(stderr, "gliftc: cannot run '%s'\n", arguments[0]);
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status)) return WEXITSTATUS(status);
    std::fprintf(stderr, "gliftc: '%s' was ended by signal %d\n", words[0].c_str(), WTERMSIG(status));
    return 1;
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

/// Builds and runs the program that one generated source is. Its exit code.
int build_and_run(const Options& options, const RuntimePaths& runtime, const fs::path& source) {
    const std::string program = fs::path(source).replace_extension().string();
    std::vector<std::string> build = compiler_command();
    const std::string library = runtime.library.string();
    // -Og: less to wait for than with -O1, and good to step through. One copy of a kernel, not one a width of vectors.
    for (const std::string& word :
         {std::string("-std=c++20"), std::string("-Og"), std::string("-DGLIFT_HOST_KERNEL="),
          std::string("-ffp-contract=off"), std::string("-fwrapv"), std::string("-fno-math-errno"),
          std::string("-fno-trapping-math"), "-I" + runtime.include.string(), "-I" + source.parent_path().string(),
          source.string(), "-L" + library, "-Wl,-rpath," + library, std::string("-lglift"), std::string("-ltbb"),
          std::string("-o"), program})
        build.push_back(word);
    for (const std::string& file : options.files)
        build.insert(build.end() - 2, "-I" + fs::absolute(file).parent_path().string());
    if (run(build) != 0)
        throw std::runtime_error("the C++ compiler refused what gliftc wrote for " + source.stem().string());
    std::vector<std::string> words{program};
    if (!options.test_filter.empty()) words.insert(words.end(), {"--filter", options.test_filter});
    if (!options.device.empty()) words.insert(words.end(), {"--device", options.device});
    return run(words);
}

}  // namespace

int run_tests(const Options& given) {
    Options options = given;
    options.command = Command::test;
    options.targets = {Target::cpp, Target::host};
    options.host_only = options.device == "host";
    const RuntimePaths runtime = find_runtime();
    auto& compilation = *new Compilation;  // never taken down: see run_compile
    configure(compilation.diagnostics, options);
    const Result result = compile(options, disk(), compilation);
    if (const int code = report(compilation, options); code != 0) return code;

    const TemporaryFolder folder;
    for (const Output& output : result.outputs) {
        if (auto error = write_if_changed((folder.path() / output.name).string(), output.bytes))
            throw std::runtime_error("cannot write " + output.name + ": " + *error);
    }
    if (options.validate) setenv("GLIFT_VALIDATE", "1", 0);
    setenv("GLIFT_POISON", "1", 0);
    int code = 0;
    for (const Output& output : result.outputs) {
        if (!output.name.ends_with(".cpp")) continue;
        if (build_and_run(options, runtime, folder.path() / output.name) != 0) code = 1;
    }
    return code;
}

}  // namespace gliftc
