// A memo of runs of `gliftc test`: the files that a run read, and the program that it built. While the files are the
// same, the next run starts that program.
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

/// A record of every question that a compilation asks the disk (is there this file, what is in it), with a digest of
/// the answer.
class Questions {
public:
    FileSystem noting(const FileSystem& disk);
    /// Notes a file that was read by other means than `noting`.
    void note_read(const std::string& path);
    const std::string& text() const { return text_; }

private:
    void note(char kind, const std::string& answer, const std::string& path);

    std::string text_;
};

/// Writes the record of a run that printed no messages, and the programs that it made.
void remember_run(const std::string& record, const Questions& questions, const std::vector<TestProgram>& programs);

/// The programs of that run, if the disk answers every question as it did then.
std::optional<std::vector<TestProgram>> recall_run(const std::string& record, const FileSystem& disk);

}  // namespace gliftc
