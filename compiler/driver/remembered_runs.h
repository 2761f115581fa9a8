// A cache of runs of `gliftc test`: a record of the files that a run read, and of its test programs. As long as the
// files are the same and the programs are still in the cache, a later run with the same options starts the programs
// without compiling.
#pragma once

#include "driver/file_system.h"
#include "emit/cpp/emit.h"

#include <optional>
#include <string>
#include <vector>

namespace gliftc {

/// A test program: its name in the cache, and its tests.
struct TestProgram {
    std::string name;
    std::vector<cpp::TestName> tests;
};

/// A record of every question that a compilation asks the file system (does a file exist, what is in it, what is in a
/// folder, which file does a path lead to), each with the answer or a digest of it.
class Questions {
public:
    /// A file system that answers as `disk` does, and records each question.
    FileSystem noting(const FileSystem& disk);
    /// Records a file that was read by other means.
    void note_read(const std::string& path);
    const std::string& text() const { return text_; }

private:
    void note(char kind, const std::string& answer, const std::string& path);

    std::string text_;
};

/// Writes the record of a run to the file `record`. Writes nothing if a test's title has a line break, since the record
/// has one line for each test. To be called for runs without messages only, since a recalled run prints none.
void remember_run(const std::string& record, const Questions& questions, const std::vector<TestProgram>& programs);

/// The programs of a recorded run, if the disk answers every question as it did then; else absent.
std::optional<std::vector<TestProgram>> recall_run(const std::string& record, const FileSystem& disk);

}  // namespace gliftc
