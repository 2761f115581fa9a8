#include "base/parallel.h"
#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/compile.h"
#include "driver/environment.h"

#include <cstdio>
#include <filesystem>

namespace gliftc {

namespace {

void print_times(const Result& result) {
    double all = 0;
    for (const StageTime& time : result.times) all += time.milliseconds;
    for (const StageTime& time : result.times)
        std::fprintf(stderr, "%-10.*s %9.3f ms %5.1f %%\n", static_cast<int>(time.stage.size()), time.stage.data(),
                     time.milliseconds, all > 0 ? 100 * time.milliseconds / all : 0.0);
    std::fprintf(stderr, "%-10s %9.3f ms\n", "all", all);
}

/// Throws EnvironmentError if `error`, the error of writing this file, is present. Hence only the first failure is
/// reported: others usually have the same cause.
void check_written(const std::string& path, const std::optional<std::string>& error) {
    if (error) throw EnvironmentError("cannot write '" + path + "': " + *error);
}

/// The path of the depfile. If the options give none, it lies beside the outputs: the name of the first file on the
/// command line followed by `.d`; for standard input, the name of the first output with `.d` in place of its last
/// extension. Empty, so that no depfile is written, if the options give no path and either there are no outputs, or
/// --target is given without -MD.
std::string depfile_of(const Options& options, const Result& result) {
    if (!options.depfile.empty() || result.outputs.empty()) return options.depfile;
    if (!options.targets.empty() && !options.writes_depfile) return {};
    const bool is_stdin = options.files.front() == "-";
    const std::filesystem::path named = options.files.front(), first = result.outputs.front().name;
    return options.output_folder + "/" + (is_stdin ? first.stem() : named.filename()).string() + ".d";
}

void write_outputs(const Options& options, const Result& result, const Compilation& compilation) {
    constexpr std::size_t share = 64;  // starting a thread for fewer outputs does not pay off
    const auto path_of = [&](const Output& output) { return options.output_folder + "/" + output.name; };
    std::vector<std::optional<std::string>> errors(result.outputs.size());
    for_each_parallel(result.outputs.size(), share, [&](std::size_t i) {
        errors[i] = write_if_changed(path_of(result.outputs[i]), result.outputs[i].bytes);
    });
    for (std::size_t i = 0; i < errors.size(); ++i) check_written(path_of(result.outputs[i]), errors[i]);
    std::string depfile = depfile_of(options, result);
    if (!depfile.empty()) check_written(depfile, write_if_changed(depfile, make_depfile(options, result, compilation)));
}

}  // namespace

int run_compile(const Options& options) {
    // Never destroyed: the process ends after this, and freeing a large tree would only take time.
    auto& compilation = *new Compilation;
    configure(compilation.diagnostics, options);
    Result result = compile(options, disk(), compilation);
    int code = report(compilation, options);
    std::fwrite(result.dump.data(), 1, result.dump.size(), stdout);
    if (options.time_report) print_times(result);
    if (code != 0 || options.check_only) return code;
    if (options.list_outputs) {
        for (const Output& output : result.outputs) std::printf("%s\n", output.name.c_str());
        return code;
    }
    const bool stops =
        options.stop_after || options.dump || !options.stop_after_pass.empty() || !options.dump_after.empty();
    if (!stops) write_outputs(options, result, compilation);
    return code;
}

}  // namespace gliftc
