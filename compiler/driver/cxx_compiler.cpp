#include "driver/cxx_compiler.h"

#include "driver/environment.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

constexpr int cannot_run = 127;
constexpr int not_collected = -1;

/// A folder with fewer bytes available is full: a test program and its object files need more.
constexpr std::uintmax_t little_space = std::uintmax_t{2} << 20;

/// Starts a program. `messages` is a file for its standard error, or not_collected.
pid_t start(const std::vector<std::string>& words, int messages) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw EnvironmentError("cannot start " + words[0] + ": " + std::strerror(errno));
    if (child != 0) return child;
    if (messages != not_collected) {
        dup2(messages, STDERR_FILENO);
        setenv("LC_ALL", "C.UTF-8", 1);  // has_error_in() and lack_of_resources() look for English words
    }
    execvp(arguments[0], arguments.data());
    _exit(cannot_run);
}

Ended wait_for(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return {1, 0};
    if (WIFEXITED(status)) return {WEXITSTATUS(status), 0};
    return {1, WTERMSIG(status)};
}

std::string all_of(int file) {
    std::string text;
    char piece[1 << 12];
    for (ssize_t got = 0; (got = pread(file, piece, sizeof piece, static_cast<off_t>(text.size()))) > 0;)
        text.append(piece, static_cast<std::size_t>(got));
    return text;
}

bool has_any(const std::string& text, std::initializer_list<const char*> words) {
    return std::ranges::any_of(words, [&](const char* word) { return text.find(word) != std::string::npos; });
}

bool is_full(const fs::path& folder) {
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    return !error && space.available < little_space;
}

}  // namespace

Ended run_and_wait(const std::vector<std::string>& words) { return wait_for(start(words, not_collected)); }

std::vector<std::string> compiler_words() {
    const char* chosen = std::getenv("CXX");
    std::istringstream text(chosen ? chosen : "");
    std::vector<std::string> words;
    for (std::string word; text >> word;) words.push_back(word);
    if (words.empty()) words.emplace_back("c++");
    return words;
}

CompilerRun::CompilerRun(const std::vector<std::string>& words)
    : collected_(memfd_create("messages of the C++ compiler", MFD_CLOEXEC)) {
    child_ = start(words, collected_);
}

CompilerRun::CompilerRun(CompilerRun&& other) noexcept
    : ended(other.ended), messages(std::move(other.messages)), child_(std::exchange(other.child_, 0)),
      collected_(std::exchange(other.collected_, not_collected)) {}

CompilerRun::~CompilerRun() {
    if (child_ != 0) wait_for(child_);
    if (collected_ != not_collected) close(collected_);
}

bool CompilerRun::wait() {
    ended = wait_for(std::exchange(child_, 0));
    messages = all_of(collected_);
    std::fwrite(messages.data(), 1, messages.size(), stderr);
    if (ended.code == cannot_run)
        throw EnvironmentError("'gliftc test' and 'gliftc watch' need a C++ compiler, and there is no '" +
                               compiler_words()[0] + "' here: install one (Debian: g++), or name one in CXX");
    return ended.code == 0;
}

bool has_error_in(const fs::path& folder, const std::string& messages) {
    std::istringstream lines(messages);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(folder.string() + "/") && line.find(": error: ") != std::string::npos) return true;
    return false;
}

std::string lack_of_resources(const CompilerRun& failed, const fs::path& folder) {
    std::error_code ignored;
    for (const fs::path& each : {folder, fs::temp_directory_path(ignored)})
        if (is_full(each)) return "there is no space in " + each.string();
    if (has_any(failed.messages, {"No space left on device"}))
        return "there is no space in " + folder.string() + " or in the folder for temporary files (TMPDIR)";
    if (failed.ended.signal == SIGKILL ||
        has_any(failed.messages, {"memory exhausted", "out of memory", "Cannot allocate memory", "bad_alloc",
                                  "Killed signal", "mmap: "}))
        return "the compiler had not enough memory";
    return {};
}

std::string how_it_ended(const Ended& ended) {
    if (ended.signal == 0) return "it exited with code " + std::to_string(ended.code);
    return "signal " + std::to_string(ended.signal) + " (" + strsignal(ended.signal) + ") ended it";
}

}  // namespace gliftc
