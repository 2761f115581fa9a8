// The whole compiler as one function; it touches nothing but the files it is given.
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

/// Everything one compilation owns. Separate from compile() so that its caller can render diagnostics with the sources,
/// and may end the process without destroying it.
struct Compilation {
    Sources sources;
    Names names;
    ast::Tree tree;
    Diagnostics diagnostics;
    LoadedModules loaded;
    ir::Program program;
    ir::Lowered lowered;
    std::vector<std::string> read_files;  ///< besides the sources: imported C++ headers
};

struct Output {
    std::string name;  ///< of the file, in the output folder
    std::string bytes;
    std::vector<cpp::TestName> tests{};  ///< of a test program
};

struct StageTime {
    std::string_view stage;
    double milliseconds;
};

struct Result {
    std::vector<Output> outputs;  ///< empty where there are errors
    std::string dump;             ///< of `--dump=`
    std::vector<StageTime> times;
};

/// Runs the stages that the options ask for; stops after the first that reports an error.
Result compile(const Options& options, const FileSystem& files, Compilation& compilation);

/// Checks and compiles a text on its own, for fuzzers: no file is read or written.
Diagnostics check_text(std::string_view text);

/// A Makefile rule: the outputs depend on every file that was read. Paths as the compiler opened them.
std::string make_depfile(const Options& options, const Result& result, const Compilation& compilation);

}  // namespace gliftc
