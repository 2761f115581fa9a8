// Builds test programs with the system's C++ compiler, and caches them and their objects by hashes of their inputs.
#pragma once

#include "driver/compile.h"
#include "driver/cxx_compiler.h"
#include "driver/digest.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gliftc {

/// What a test program is built of.
struct TestSources {
    std::vector<Output> outputs;
    std::vector<std::string> include_folders;  ///< where the C++ compiler looks for imported headers
    std::vector<std::string> read_files;  ///< as Compilation::read_files: the imported headers, the file of --style
};

/// The cache of test programs: the folder `tests` in GLIFT_CACHE_DIR, else in XDG_CACHE_HOME/glift, else in
/// ~/.cache/glift. If none of these is set, or the folder cannot be written, a temporary folder that the destructor
/// removes. After each build the oldest of more than 512 entries are removed.
class TestPrograms {
public:
    TestPrograms();
    ~TestPrograms();
    TestPrograms(const TestPrograms&) = delete;
    TestPrograms& operator=(const TestPrograms&) = delete;

    /// The cache's name of the program: a hash of the outputs, the folders' paths, what read_files contain, the
    /// compiler's options, and tools_.
    std::string name_of(const TestSources& sources) const;
    /// Whether the cache has the program, which may be from an earlier run.
    bool has(const std::string& name) const;
    /// Builds the program; sources that an earlier build had, too, are not compiled again. Throws EnvironmentError if
    /// the C++ compiler fails, but std::runtime_error if it refuses what gliftc wrote.
    void build(const std::string& name, const TestSources& sources);
    /// The path of a program that the cache has. Makes its entry the newest one, the last to be removed.
    std::string use(const std::string& name) const;

    /// The file for the record of a run with these options (remembered_runs.h).
    std::string record_of(const Options& options) const;

private:
    void compile(const std::filesystem::path& folder, const TestSources& sources);
    [[noreturn]] void refuse(const CompilerRun& run, const std::string& step, const std::string& stem,
                             const std::filesystem::path& folder);
    bool can_compile_headers(const std::filesystem::path& folder) const;
    Digest digest_of_surroundings(const TestSources& sources) const;
    std::filesystem::path object_of(const Output& source, const TestSources& sources) const;
    std::vector<std::string> compile_command() const;
    std::filesystem::path compiled_headers(std::size_t sources);
    void remove_oldest() const;

    std::filesystem::path include_, library_;  ///< the runtime's headers and library, found by this executable's path
    std::filesystem::path folder_;
    bool is_temporary_ = false;
    std::string tools_;  ///< a hash of the paths, sizes and times of the C++ compiler and of the runtime
};

}  // namespace gliftc
