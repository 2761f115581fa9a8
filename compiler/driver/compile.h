// The whole compiler as one function. It reads files through a FileSystem (but clang reads the C++ headers of `extern
// struct`, and the file of --style) and returns its outputs instead of writing them.
#pragma once

#include "driver/file_system.h"
#include "driver/load.h"
#include "driver/options.h"
#include "emit/cpp/emit.h"
#include "ir/pass.h"

#include <string>
#include <string_view>
#include <vector>

namespace gliftc {

/// Everything that one compilation owns. The caller of compile() has it, to render diagnostics with the sources, and to
/// end the process without destroying it, which saves time.
struct Compilation {
    Sources sources;
    Names names;
    ast::Tree tree;
    Diagnostics diagnostics;
    LoadedModules loaded;
    ir::Program program;
    ir::Lowered lowered;
    std::vector<std::string> read_files;  ///< files read besides the sources: imported C++ headers, but for those of
                                          ///< the system, and the file of --style
};

struct Output {
    std::string name;  ///< file name in the output folder
    std::string bytes;
    std::vector<cpp::TestName> tests{};  ///< of the main source of a test program: the tests that it runs; else empty
};

struct StageTime {
    std::string_view stage;
    double milliseconds;
};

struct Result {
    std::vector<Output> outputs;  ///< empty if there are errors, or the options or command stop before they are made
    std::string dump;             ///< the text that `--dump=` or `--dump-after=` asks for
    std::vector<StageTime> times;
};

/// Runs the stages that the options ask for; stops after the first that reports an error (after sema, if the only
/// errors are names of modules that do not match their files; after layout, if lowering reports errors and its result
/// is to be dumped).
Result compile(const Options& options, const FileSystem& files, Compilation& compilation);

/// Compiles one text as the only file that exists, for fuzzers; returns what was reported.
Diagnostics check_text(std::string_view text);

/// A Makefile rule by which the outputs depend on every file that was read, but for standard input and the system's C++
/// headers. Its paths are those by which the files were found.
std::string make_depfile(const Options& options, const Result& result, const Compilation& compilation);

}  // namespace gliftc
