// --dump-after: the text of kernels after every pass can be parsed, and prints to the same text again, comments left
// out. The kernels are those of the golden tests and of the tests of passes.
#include "driver/compile.h"
#include "ir/print.h"
#include "ir/read.h"
#include "lower/passes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace gliftc {
namespace {

std::vector<std::filesystem::path> sources() {
    std::vector<std::filesystem::path> found;
    for (const char* folder : {"/tests/golden", "/tests/passes"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(std::string(GLIFT_SOURCE_DIR) + folder))
            if (entry.path().extension() == ".glift" && entry.path().parent_path().filename() != "support")
                found.push_back(entry.path());
    return found;
}

std::set<std::string> pass_names() {
    std::set<std::string> names;
    for (const lower::BodyPass& pass : lower::body_passes()) names.emplace(pass.name);
    for (const lower::BodyPass& pass : lower::host_passes()) names.emplace(pass.name);
    for (const lower::KernelPass& pass : lower::kernel_passes()) names.emplace(pass.name);
    return names;
}

std::string dumped(const std::filesystem::path& file, const std::string& pass) {
    Options options;
    options.files = {file.string()};
    options.import_folders = {(file.parent_path() / "support").string()};
    options.library_folder = GLIFT_SOURCE_DIR "/stdlib";
    options.dump_after = pass;
    Compilation compilation;
    Result result = compile(options, disk(), compilation);
    EXPECT_FALSE(compilation.diagnostics.has_errors()) << file;
    return result.dump;
}

std::string without_comments(const std::string& text) {
    std::string kept;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at) + 1;
        if (text.compare(at, 2, "//") != 0) kept += text.substr(at, end - at);
        at = end;
    }
    return kept;
}

TEST(DumpAfter, ReadsBackAsItWasForEveryPass) {
    std::set<std::string> seen;
    for (const std::string& pass : pass_names()) {
        for (const std::filesystem::path& file : sources()) {
            SCOPED_TRACE(file.filename().string() + " after " + pass);
            const std::string text = dumped(file, pass);
            if (!text.empty()) seen.insert(pass);
            Names names;
            ir::Program program;
            program.names = &names;
            std::string again;
            try {
                for (const ir::ReadPass& read : ir::read_passes(program, text))
                    again += ir::print(program, read.pass, read.facts) + "\n";
            } catch (const ir::ReadError& error) {
                ADD_FAILURE() << error.what();
            }
            EXPECT_EQ(again, without_comments(text));
        }
    }
    EXPECT_EQ(seen, pass_names());
}

}  // namespace
}  // namespace gliftc
