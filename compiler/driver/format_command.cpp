#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/compile.h"

#include "syntax/format.h"

#include <cstdio>

namespace gliftc {

namespace {

/// Writes the formatted text to the file or, for "-", to standard output. With --check it writes no text, but prints
/// the path if the file is not formatted. Returns whether the file was not formatted; sets `code` if it cannot be
/// written.
bool put(const Options& options, const std::string& path, const std::string& before, const std::string& after,
         int& code) {
    if (path == "-" && !options.check_only) std::fwrite(after.data(), 1, after.size(), stdout);
    if (before == after) return false;
    if (options.check_only) {
        std::printf("%s\n", path.c_str());
    } else if (path != "-") {
        if (auto error = replace_file(path, after)) {
            std::fprintf(stderr, "error: cannot write '%s': %s\n", path.c_str(), error->c_str());
            code = static_cast<int>(ExitCode::environment);
        }
    }
    return true;
}

}  // namespace

int run_format(const Options& options) {
    auto& compilation = *new Compilation;  // never destroyed: see run_compile
    configure(compilation.diagnostics, options);
    FileSystem files = disk();
    int code = static_cast<int>(ExitCode::done);
    bool any_changed = false;
    for (const std::string& path : options.files) {
        // The limit is for each file: a file must be read to its end to be formatted, whatever is wrong in others.
        if (options.error_limit)
            compilation.diagnostics.error_limit = compilation.diagnostics.error_count() + options.error_limit;
        ReadResult read = files.read(path);
        if (!read.error.empty()) {
            compilation.diagnostics.report(Diag::cannot_read, {}, {path, read.error});
            continue;
        }
        std::uint32_t file = compilation.sources.add(path == "-" ? "<stdin>" : path, std::move(read.text));
        auto formatted = format(file, compilation.sources, compilation.names, compilation.diagnostics);
        if (formatted) any_changed |= put(options, path, compilation.sources[file].text, *formatted, code);
    }
    if (int reported = report(compilation, options); reported != 0) return reported;
    return options.check_only && any_changed ? static_cast<int>(ExitCode::source_errors) : code;
}

}  // namespace gliftc
