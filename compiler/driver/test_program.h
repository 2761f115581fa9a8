// The program that a file's tests become: built by the system's C++ compiler, once for what it is made of.
#pragma once

#include "driver/compile.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gliftc {

/// How a program ended.
struct Ended {
    int code = 0;
    int signal = 0;  ///< that ended it; 0: it ended by itself
};

/// Runs a program with this one's input and outputs.
Ended run_and_wait(const std::vector<std::string>& words);

/// Test programs, in the user's cache folder: GLIFT_CACHE_DIR, else XDG_CACHE_HOME/glift, else ~/.cache/glift. The
/// oldest are removed. Where there is no such folder, in one that goes with this object.
class TestPrograms {
public:
    TestPrograms();
    ~TestPrograms();
    TestPrograms(const TestPrograms&) = delete;
    TestPrograms& operator=(const TestPrograms&) = delete;

    /// The program made of `outputs`, in which the C++ compiler looks for headers in `include_folders`. It is built
    /// where it is not there from an earlier run with the same outputs, headers, runtime and compiler. Throws
    /// std::runtime_error where the compiler refuses it.
    std::string program(const std::vector<Output>& outputs, const std::vector<std::string>& include_folders,
                        const std::vector<std::string>& read_files);

private:
    std::filesystem::path build(const std::filesystem::path& folder, const std::vector<Output>& outputs,
                                const std::vector<std::string>& include_folders);
    std::vector<std::string> compile_command() const;
    std::filesystem::path compiled_headers();
    void remove_oldest() const;

    std::filesystem::path include_, library_;  ///< the runtime beside this executable
    std::filesystem::path folder_;
    bool is_temporary_ = false;
    std::string tools_;  ///< what the compiler and the runtime are
};

}  // namespace gliftc
