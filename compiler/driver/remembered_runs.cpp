#include "driver/remembered_runs.h"

#include "driver/digest.h"

#include <algorithm>
#include <sstream>

namespace gliftc {

namespace {

// The first letters of the lines of a record. A question is a line of its letter, the answer or its digest, and the
// path. The lines of the programs follow, each with the lines of its tests.
constexpr char reads = 'r', exists = 'e', identity = 'i', lists = 'l', program = 'p', test = 't';

/// Stands for a space in the place of a test, which a space ends.
constexpr char space_in_place = '\x1f';

std::string with(std::string text, char instead_of, char by) {
    std::ranges::replace(text, instead_of, by);
    return text;
}

std::string digest_of(const std::string& text) {
    Digest digest;
    digest.add(text);
    return digest.digits();
}

std::string answer_of(const ReadResult& result) { return digest_of(result.error.empty() ? result.text : "?"); }

std::string answer_of(const std::vector<std::string>& names) {
    Digest digest;
    for (const std::string& name : names) digest.add(name);
    return digest.digits();
}

/// The answer of the disk to a question now; empty if the letter is not that of a question.
std::string answer_now(char kind, const std::string& path, const FileSystem& disk) {
    switch (kind) {
    case reads: return answer_of(disk.read(path));
    case exists: return disk.exists(path) ? "1" : "0";
    case identity: return digest_of(disk.identity(path));
    case lists: return answer_of(disk.list(path));
    default: return {};
    }
}

}  // namespace

void Questions::note(char kind, const std::string& answer, const std::string& path) {
    text_ += std::string(1, kind) + " " + answer + " " + path + "\n";
}

FileSystem Questions::noting(const FileSystem& disk) {
    return {[this, disk](const std::string& path) {
                ReadResult result = disk.read(path);
                note(reads, answer_of(result), path);
                return result;
            },
            [this, disk](const std::string& path) {
                const bool is_there = disk.exists(path);
                note(exists, is_there ? "1" : "0", path);
                return is_there;
            },
            [this, disk](const std::string& folder) {
                std::vector<std::string> names = disk.list(folder);
                note(lists, answer_of(names), folder);
                return names;
            },
            [this, disk](const std::string& path) {
                std::string found = disk.identity(path);
                note(identity, digest_of(found), path);
                return found;
            }};
}

void Questions::note_read(const std::string& path) { note(reads, answer_now(reads, path, disk()), path); }

void remember_run(const std::string& record, const Questions& questions, const std::vector<TestProgram>& programs) {
    std::string text = questions.text();
    for (const TestProgram& made : programs) {
        text += std::string(1, program) + " " + made.name + " \n";
        for (const cpp::TestName& each : made.tests) {
            if (each.title.find('\n') != std::string::npos) return;
            text += std::string(1, test) + " " + with(each.place, ' ', space_in_place) + " " + each.title + "\n";
        }
    }
    write_if_changed(record, text);
}

std::optional<std::vector<TestProgram>> recall_run(const std::string& record, const FileSystem& disk) {
    const ReadResult found = disk.read(record);
    if (!found.error.empty()) return std::nullopt;
    std::vector<TestProgram> programs;
    std::istringstream lines(found.text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t space = line.find(' ', 2);
        if (space == std::string::npos) return std::nullopt;
        const std::string answer = line.substr(2, space - 2), rest = line.substr(space + 1);
        if (line[0] == program) programs.push_back({answer, {}});
        else if (line[0] == test && !programs.empty())
            programs.back().tests.push_back({rest, with(answer, space_in_place, ' ')});
        else if (answer_now(line[0], rest, disk) != answer) return std::nullopt;
    }
    return programs;
}

}  // namespace gliftc
