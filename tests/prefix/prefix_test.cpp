// Compiles every file of the library, the examples and the golden tests, cut off at each of many places, and writes no
// outputs: the compiler must report an error where a brace, parenthesis or bracket is left open, and must never crash.

#include "driver/compile.h"
#include "support/process.h"
#include "syntax/lexer.h"

#include <csignal>
#include <cstdio>
#include <gtest/gtest.h>
#include <unistd.h>

namespace glift::test {
namespace {

/// A file is cut every size / cuts bytes (rounded down, at least 1), thus at fewer than 2 * cuts places.
constexpr std::size_t cuts = 150;

/// Which part of which file is being compiled: a message that is printed if the compiler crashes.
char now_compiling[512];

void print_cut(int signal) {
    [[maybe_unused]] const ssize_t written = write(2, now_compiling, std::char_traits<char>::length(now_compiling));
    std::signal(signal, SIG_DFL);
    raise(signal);
}

/// The files of the disk, with the text of one replaced.
gliftc::FileSystem disk_with(const std::string& path, const std::string& text) {
    gliftc::FileSystem files = gliftc::disk();
    files.read = [path, text, read = files.read](const std::string& wanted) {
        return wanted == path ? gliftc::ReadResult{text, {}} : read(wanted);
    };
    return files;
}

bool leaves_something_open(const std::string& text) {
    gliftc::Sources sources;
    gliftc::Names names;
    gliftc::Diagnostics diagnostics;
    const std::uint32_t file = sources.add("cut.glift", text);
    int open = 0;
    for (const gliftc::Token& token : gliftc::lex(file, sources, names, diagnostics).tokens) {
        using enum gliftc::TokenKind;
        if (token.kind == open_brace || token.kind == open_paren || token.kind == open_bracket) ++open;
        if (token.kind == close_brace || token.kind == close_paren || token.kind == close_bracket) --open;
    }
    return open > 0;
}

class Prefix : public testing::TestWithParam<std::filesystem::path> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Prefix);

TEST_P(Prefix, gives_errors_and_never_a_crash) {
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) std::signal(signal, print_cut);
    const std::string path = GetParam().string();
    const std::string whole = read_file(GetParam());
    gliftc::Options options;
    options.files = {path};
    options.library_folder = GLIFT_SOURCE_DIR "/stdlib";
    options.import_folders = {(GetParam().parent_path() / "support").string()};
    options.check_only = true;
    const std::size_t step = std::max<std::size_t>(1, whole.size() / cuts);
    for (std::size_t size = 0; size < whole.size(); size += step) {
        std::snprintf(now_compiling, sizeof now_compiling, "crashed on the first %zu bytes of %s\n", size,
                      path.c_str());
        const std::string cut = whole.substr(0, size);
        gliftc::Compilation compilation;
        gliftc::compile(options, disk_with(path, cut), compilation);
        if (leaves_something_open(cut)) {
            EXPECT_TRUE(compilation.diagnostics.has_errors()) << "the first " << size << " bytes are accepted";
        }
    }
}

std::vector<std::filesystem::path> all_files() {
    std::vector<std::filesystem::path> all;
    for (const char* folder : {"/stdlib", "/examples", "/tests/golden"}) {
        for (const auto& file : files_under(std::string(GLIFT_SOURCE_DIR) + folder, ".glift")) all.push_back(file);
    }
    return all;
}

std::string case_name(const testing::TestParamInfo<std::filesystem::path>& info) {
    std::string name = std::filesystem::relative(info.param, GLIFT_SOURCE_DIR).replace_extension();
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(, Prefix, testing::ValuesIn(all_files()), case_name);

}  // namespace
}  // namespace glift::test
