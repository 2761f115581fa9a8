// Builds test programs with the system's C++ compiler, and caches them by a hash of their inputs.
#pragma once

#include "driver/compile.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gliftc {

/// How a program ended.
struct Ended {
    int code = 0;
    int signal = 0;  ///< that ended it; 0: it exited
};

/// Runs a program with this one's input and outputs.
Ended run_and_wait(const std::vector<std::string>& words);

/// The cache of test programs: GLIFT_CACHE_DIR, else XDG_CACHE_HOME/glift, else ~/.cache/glift. The oldest are removed.
/// If there is no such folder, a temporary one that this object removes.
class TestPrograms {
public:
    TestPrograms();
    ~TestPrograms();
    TestPrograms(const TestPrograms&) = delete;
    TestPrograms& operator=(const TestPrograms&) = delete;

    /// The name of the program made of `outputs`, in which the C++ compiler looks for headers in `include_folders`: the
    /// same for the same outputs, headers, runtime and compiler.
    std::string name_of(const std::vector<Output>& outputs, const std::vector<std::string>& include_folders,
                        const std::vector<std::string>& read_files) const;
    /// Whether it is there from an earlier run.
    bool has(const std::string& name) const;
    /// Builds it. Throws std::runtime_error where the compiler refuses it.
    void build(const std::string& name, const std::vector<Output>& outputs,
               const std::vector<std::string>& include_folders);
    /// The path of one that is there.
    std::string use(const std::string& name) const;

    /// The file in which a run with these options is remembered.
    std::string record_of(const Options& options) const;

private:
    void compile(const std::filesystem::path& folder, const std::vector<Output>& outputs,
                 const std::vector<std::string>& include_folders);
    std::vector<std::string> compile_command() const;
    std::filesystem::path compiled_headers();
    void remove_oldest() const;

    std::filesystem::path include_, library_;  ///< the runtime beside this executable
    std::filesystem::path folder_;
    bool is_temporary_ = false;
    std::string tools_;  ///< identifies the versions of the compiler and the runtime
};

}  // namespace gliftc
