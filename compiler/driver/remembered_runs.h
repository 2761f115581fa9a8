// What a run of `gliftc test` asked the disk and what it made: while the answers are the same, so is what they lead to.
#pragma once

#include "driver/file_system.h"
#include "emit/cpp/emit.h"

#include <optional>
#include <string>
#include <vector>

namespace gliftc {

/// A test program by its name in the cache, and the tests in it.
struct TestProgram {
    std::string name;
    std::vector<cpp::TestName> tests;
};

/// Notes every question that a compilation asks the disk, with a digest of the answer.
class Questions {
public:
    FileSystem noting(const FileSystem& disk);
    /// A file that was read in another way.
    void note_read(const std::string& path);
    const std::string& text() const { return text_; }

private:
    void note(char kind, const std::string& answer, const std::string& path);

    std::string text_;
};

/// Writes what a run without messages asked and made.
void remember_run(const std::string& record, const Questions& questions, const std::vector<TestProgram>& programs);

/// What it made, if the disk would answer the same.
std::optional<std::vector<TestProgram>> recall_run(const std::string& record, const FileSystem& disk);

}  // namespace gliftc
