// For tests: runs a program and captures its output; temporary folders; reads, writes and finds files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace glift::test {

struct ProcessResult {
    int exit_code = 0;  ///< 128 + the signal's number if a signal ended the program
    std::string out;
    std::string err;
};

/// Runs arguments[0] (looked up in PATH) and waits. `input` becomes its standard input.
ProcessResult run_process(const std::vector<std::string>& arguments, const std::string& input = {});

/// A temporary folder, removed with the object.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& text);

/// Every file under `folder` with this suffix, sorted; none if there is no folder. Skips folders named "support".
std::vector<std::filesystem::path> files_under(const std::filesystem::path& folder, const std::string& ending);

}  // namespace glift::test
