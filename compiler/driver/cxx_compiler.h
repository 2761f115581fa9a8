// Runs programs: the system's C++ compiler, whose failures it explains, and what the compiler built.
#pragma once

#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace gliftc {

/// How a program ended.
struct Ended {
    int code = 0;
    int signal = 0;  ///< the signal that ended the program; 0: it exited
};

/// Runs a program with the standard input and outputs of this one, and waits for it.
Ended run_and_wait(const std::vector<std::string>& words);

/// The words of CXX, which may hold a launcher ("ccache g++") and options; "c++" if it is not set or blank.
std::vector<std::string> compiler_words();

/// A run of the C++ compiler. Its messages are collected, and printed by wait(), so that those of several runs do not
/// mix. Throws EnvironmentError if the run cannot be started.
class CompilerRun {
public:
    explicit CompilerRun(const std::vector<std::string>& words);
    CompilerRun(CompilerRun&& other) noexcept;
    CompilerRun& operator=(CompilerRun&&) = delete;
    ~CompilerRun();

    /// Waits for the end; true if the compiler succeeded. Throws EnvironmentError if there is no such program.
    bool wait();

    Ended ended;           ///< after wait()
    std::string messages;  ///< after wait(): what the compiler wrote to its standard error

private:
    pid_t child_ = 0;
    int collected_ = -1;  ///< a file in memory: messages are collected where the disk is full, too
};

/// Whether one of the messages is an error about a file in `folder`.
bool has_error_in(const std::filesystem::path& folder, const std::string& messages);

/// Why the compiler failed if its surroundings are to blame: no space in `folder` or for temporary files, or no memory.
/// Empty if neither.
std::string lack_of_resources(const CompilerRun& failed, const std::filesystem::path& folder);

/// "it exited with code 1" or "signal 9 (Killed) ended it".
std::string how_it_ended(const Ended& ended);

}  // namespace gliftc
