#include "driver/command_line.h"

#include "base/version.h"
#include "driver/load.h"
#include "driver/response_file.h"
#include "driver/shell_files.h"
#include "lower/passes.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

namespace gliftc {

namespace {

const std::map<std::string, Target> target_names{{"glsl", Target::glsl},
                                                 {"spirv", Target::spirv},
                                                 {"cpp", Target::cpp},
                                                 {"host", Target::host},
                                                 {"json", Target::json}};
const std::map<std::string, Stage> stage_names{{"syntax", Stage::syntax},
                                               {"sema", Stage::sema},
                                               {"ir", Stage::sema},
                                               {"lower", Stage::lower},
                                               {"layout", Stage::layout}};
const std::map<std::string, DiagnosticsFormat> format_names{{"text", DiagnosticsFormat::text},
                                                            {"json", DiagnosticsFormat::json}};
const std::map<std::string, ColourChoice> colour_names{
    {"auto", ColourChoice::automatic}, {"always", ColourChoice::always}, {"never", ColourChoice::never}};

/// Values of options as typed; converted to Options once all are parsed.
struct Typed {
    std::vector<std::string> defines, warnings;
    std::string stop_after, dump, format, colour;
    std::vector<std::string> targets;
};

/// The value that `names` has for `word`. Throws ValidationError, which CLI11 reports as wrong usage, if it has none.
template <class T>
T look_up(const std::map<std::string, T>& names, const std::string& option, const std::string& word) {
    if (auto found = names.find(word); found != names.end()) return found->second;
    std::string all;
    for (const auto& [name, value] : names) all += (all.empty() ? "" : ", ") + name;
    throw CLI::ValidationError(option, "'" + word + "' is none of: " + all);
}

/// Throws ValidationError if there is no pass of that name.
void check_pass(const std::string& option, const std::string& word) {
    if (lower::is_pass(word)) return;
    std::set<std::string_view> names;
    for (const lower::BodyPass& pass : lower::body_passes()) names.insert(pass.name);
    for (const lower::BodyPass& pass : lower::host_passes()) names.insert(pass.name);
    for (const lower::KernelPass& pass : lower::kernel_passes()) names.insert(pass.name);
    std::string all;
    for (std::string_view name : names) all += (all.empty() ? "" : ", ") + std::string(name);
    throw CLI::ValidationError(option, "'" + word + "' is none of: " + all);
}

void read_warning(Options& options, const std::string& word) {
    if (word == "error") {
        options.warnings_are_errors = true;
        return;
    }
    if (word == "all") return;
    bool silence = word.starts_with("no-"), promote = word.starts_with("error=");
    std::string id = silence ? word.substr(3) : promote ? word.substr(6) : word;
    auto diag = find_diagnostic(id);
    if (!diag || severity_of(*diag) != Severity::warning)
        throw CLI::ValidationError("-W" + word, "there is no warning '" + id + "'");
    if (silence) options.silenced.push_back(*diag);
    if (promote) options.promoted.push_back(*diag);
}

void finish(Options& options, const Typed& typed) {
    for (const std::string& word : typed.targets) options.targets.push_back(look_up(target_names, "--target", word));
    if (lower::is_pass(typed.stop_after)) options.stop_after_pass = typed.stop_after;
    else if (!typed.stop_after.empty()) options.stop_after = look_up(stage_names, "--stop-after", typed.stop_after);
    if (!options.dump_after.empty()) check_pass("--dump-after", options.dump_after);
    if (!typed.dump.empty()) options.dump = look_up(stage_names, "--dump", typed.dump);
    if (!typed.format.empty()) options.diagnostics_format = look_up(format_names, "--diagnostics-format", typed.format);
    if (!typed.colour.empty()) options.colour = look_up(colour_names, "--color", typed.colour);
    for (const std::string& word : typed.warnings) read_warning(options, word);
    for (const std::string& define : typed.defines) {
        std::size_t equal = define.find('=');
        if (equal == 0 || equal == std::string::npos)
            throw CLI::ValidationError("-D", "'" + define + "' is not 'name=value'");
        options.defines.emplace_back(define.substr(0, equal), define.substr(equal + 1));
    }
}

/// Throws ValidationError if the outputs of two files would have one name.
void check_file_names(const Options& options) {
    std::map<std::string, std::string> by_stem;
    for (const std::string& file : options.files) {
        if (file == "-") continue;
        const std::filesystem::path path(file);
        const auto [earlier, is_new] = by_stem.try_emplace(path.stem().string(), file);
        std::error_code unknown;  // set if a file is missing; that is reported when the file is read
        if (is_new || file == earlier->second || std::filesystem::equivalent(path, earlier->second, unknown)) continue;
        throw CLI::ValidationError("files", "'" + earlier->second + "' and '" + file +
                                                "' are written to files of one name, '" + path.stem().string() +
                                                ".glift.hpp': rename one, or compile them by two calls with "
                                                "different folders (-o)");
    }
}

/// Throws ValidationError for a --depfile where no outputs are written, or for another command than compile; for two
/// files whose outputs would have the same names; for '-' as output folder or depfile; and for a --library folder
/// without the module std.transfer: such a folder cannot be the standard library.
void check_combinations(const Options& options) {
    const bool stops =
        options.stop_after || options.dump || !options.stop_after_pass.empty() || !options.dump_after.empty();
    const bool writes = !options.check_only && !options.list_outputs && !stops;
    if (!options.depfile.empty() && (!writes || options.command != Command::compile))
        throw CLI::ValidationError("--depfile", "nothing is written here: leave it out");
    const bool makes_outputs = !options.check_only && !stops;
    if (makes_outputs &&
        (options.command == Command::compile || options.command == Command::test || options.command == Command::watch))
        check_file_names(options);
    if (options.command == Command::watch && options.output_folder == ".")
        throw CLI::ValidationError("-o", "name a folder, from which programs load");
    if (options.command == Command::watch && std::ranges::find(options.files, "-") != options.files.end())
        throw CLI::ValidationError("files", "standard input cannot be watched; name a file");
    if (options.output_folder == "-")
        throw CLI::ValidationError("-o",
                                   "outputs are several files, which do not go to standard output: name a folder");
    if (options.depfile == "-") throw CLI::ValidationError("--depfile", "name a file");
    if (!options.library_folder.empty() &&
        find_in_library(disk(), options.library_folder, sema::transfer_module).empty())
        throw CLI::ValidationError("--library", "'" + options.library_folder + "' does not hold the standard library");
}

void add_output_options(CLI::App& app, Options& options, Typed& typed) {
    app.add_option("-o,--output", options.output_folder, "Write outputs into this folder")
        ->type_name("DIR")
        ->group("Output");
    app.add_option("--target", typed.targets, "What to write, repeatable: glsl, spirv, cpp, host, json (default: all)")
        ->type_name("NAME")
        ->allow_extra_args(false)
        ->group("Output");
    app.add_option("--depfile", options.depfile, "Write a Makefile rule with every file that was read (-MF)")
        ->type_name("FILE")
        ->group("Output");
    app.add_flag("--make-rule", options.writes_depfile, "Write that rule beside the outputs, as <file>.glift.d (-MD)")
        ->group("Output");
    app.add_flag("--list-outputs", options.list_outputs, "Print the names of the outputs and write nothing")
        ->group("Output");
    app.add_option("--style", options.style, "Format generated C++: a .clang-format file, or a name such as LLVM")
        ->type_name("FILE|NAME")
        ->group("Output");
    app.add_option("--address-bits", options.address_bits,
                   "Bits of physical addresses in kernels: with 64 a memory may have 2^32 elements and more")
        ->check(CLI::IsMember({32, 64}))
        ->group("Output");
    app.add_flag("--checked", options.checked, "Generated code reports accesses out of range")->group("Output");
    app.add_flag("--print,!--no-print", options.messages,
                 "Compile print and assert in, which is the default; --no-print leaves them out")
        ->group("Output");
    app.add_flag("--host-only", options.host_only, "Generated C++ holds no SPIR-V: it runs on the host device only")
        ->group("Output");
    app.add_option("--shards", options.shards,
                   "Distribute a module's kernels over N C++ sources, and over N more those it uses of other modules")
        ->type_name("N")
        ->check(CLI::Range(1, 64))
        ->group("Output");
    app.add_flag("--spirv-files", options.spirv_files,
                 "Write SPIR-V to files, which the generated C++ embeds from the folder GLIFT_SPIRV_FOLDER")
        ->group("Output");
    app.add_flag("--reload", options.reload,
                 "Generated C++ takes newer code of kernels and pipelines while the program runs: gliftc watch")
        ->group("Output");
    app.add_flag("-g", options.source_lines, "Generated C++ names the lines of its source, for debuggers")
        ->group("Output");
    app.add_flag("-O,--optimize", options.optimize, "Make SPIR-V smaller: a fifth, for up to half as much more time")
        ->group("Output");
}

void add_stage_options(CLI::App& app, Options& options, Typed& typed) {
    app.add_flag("--check", options.check_only, "Report errors and write nothing")->group("Stages");
    app.add_option("--stop-after", typed.stop_after,
                   "Stop after a stage (syntax, sema or ir, lower, layout) or a pass of lowering")
        ->type_name("STAGE")
        ->group("Stages");
    app.add_option("--dump", typed.dump, "Print the result of a stage: syntax, sema (or ir), lower, layout")
        ->type_name("STAGE")
        ->group("Stages");
    app.add_option("--dump-after", options.dump_after,
                   "Print the IR after a pass of lowering: expand, share, strengthen, …")
        ->type_name("PASS")
        ->group("Stages");
    app.add_flag("--time-report", options.time_report, "Print how long each stage took")->group("Stages");
}

void add_diagnostics_options(CLI::App& app, Options& options, Typed& typed) {
    app.add_option("--diagnostics-format", typed.format, "text (default) or json")
        ->type_name("FORMAT")
        ->group("Diagnostics");
    app.add_option("--color", typed.colour, "auto (default), always or never")->type_name("WHEN")->group("Diagnostics");
    app.add_option("-W", typed.warnings, "-Wno-ID disables a warning, -Werror turns all into errors, -Werror=ID one")
        ->type_name("ID")
        ->allow_extra_args(false)
        ->group("Diagnostics");
    app.add_option("--error-limit", options.error_limit, "Stop after so many errors; 0 is no limit")
        ->type_name("N")
        ->check(CLI::Range(0, 1000000))
        ->group("Diagnostics");
}

void add_input_options(CLI::App& app, Options& options, Typed& typed) {
    app.add_option("-I", options.import_folders, "Look for imported modules here, repeatable")
        ->type_name("DIR")
        ->allow_extra_args(false)
        ->group("Input");
    app.add_option("-D", typed.defines, "Replace the value of a constant, repeatable")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false)
        ->group("Input");
    app.add_option("--library", options.library_folder, "The folder of the standard library")
        ->type_name("DIR")
        ->group("Input");
}

/// Replaces -MD and -MF, the spellings of C compilers, by long options: CLI11 has no options with one dash and several
/// letters.
void translate_customs(std::vector<std::string>& words) {
    for (std::string& word : words) {
        if (word == "-MD") word = "--make-rule";
        else if (word.starts_with("-MF")) word = word.size() > 3 ? "--depfile=" + word.substr(3) : "--depfile";
    }
}

/// Adds a command, `gliftc NAME file.glift…`. Its own options come after its name, those of `app` before or after it.
CLI::App* add_command(CLI::App& app, Options& options, const char* name, const char* description, Command command) {
    CLI::App* sub = app.add_subcommand(name, description);
    sub->fallthrough();
    sub->add_option("files", options.files, "The files")->type_name("FILE")->required();
    sub->parse_complete_callback([&options, command] { options.command = command; });
    return sub;
}

void add_server(CLI::App& app, Options& options) {
    CLI::App* sub =
        app.add_subcommand("lsp", "Serve an editor: the language server protocol on standard input and output");
    sub->fallthrough();
    sub->add_flag_callback(
           "--stdio", [] {}, "Accepted, since some editors pass it")
        ->group("");
    sub->parse_complete_callback([&options] { options.command = Command::lsp; });
}

void add_test_command(CLI::App& app, Options& options) {
    CLI::App* test = add_command(app, options, "test",
                                 "Build and run the tests in the files, on the CPU and on a device", Command::test);
    test->add_option("--device", options.device, "The device to compare with the host: gpu, lavapipe, host or a name")
        ->type_name("NAME");
    test->add_option("--filter", options.test_filter, "Only the tests with this in their title")->type_name("TEXT");
    test->add_option("--timeout", options.test_timeout,
                     "Seconds that one test may take on both devices (default: 600; 0: no limit)")
        ->type_name("SECONDS");
    test->add_flag("!--no-validate", options.validate, "Without Vulkan's validation layer");
    test->add_flag("--list", options.list_tests, "Print the titles of the tests and run none");
}

void add_watch_command(CLI::App& app, Options& options) {
    add_command(app, options, "watch",
                "Whenever a file is saved, build its kernels and pipelines for a running program, which loads them",
                Command::watch)
        ->footer("The program's C++ comes from gliftc --reload with the same options (CMake: -DGLIFT_RELOAD=ON). It "
                 "loads from the\n"
                 "folder of -o: glift::Reload(\"DIR\"), or GLIFT_RELOAD=DIR in its environment. Control-C ends the "
                 "watch.");
}

void add_explain_command(CLI::App& app, Options& options) {
    CLI::App* explain = add_command(app, options, "explain",
                                    "Print what is known of every translator and structure in the files; or, given the "
                                    "id of a diagnostic, what it\n"
                                    "means, with an example",
                                    Command::explain);
    explain->add_flag("--json", options.explain_as_json, "As JSON");
    explain
        ->add_option(
            "--made", options.explain_made,
            "Also the bytes of this structure's memories with these arguments, repeatable: 'Grid(1024, 1024, 64)'")
        ->type_name("NAME(NUMBERS)")
        ->allow_extra_args(false);
}

void add_format_command(CLI::App& app, Options& options) {
    add_command(app, options, "fmt", "Format the files in place; with --check, say which are not formatted",
                Command::fmt)
        ->footer("Exit status: 0 done, 1 a file cannot be read or has errors, which are shown, or is not formatted "
                 "(--check),\n"
                 "4 a file cannot be written. The other files are done in any case.");
}

void add_new_command(CLI::App& app, Options& options) {
    CLI::App* make = app.add_subcommand("new", "Make a project that builds: a kernel with a test, a program, CMake");
    make->add_option("name", options.project, "The folder to make; its name is the project's")
        ->type_name("NAME")
        ->required();
    make->parse_complete_callback([&options] { options.command = Command::make_project; });
}

/// For the build: writes what installations have beside gliftc into a folder.
void add_hidden_command(CLI::App& app, std::string& folder) {
    CLI::App* shell = app.add_subcommand("shell-files", "Write manual pages and shell completion")->group("");
    shell->add_option("folder", folder)->required();
}

}  // namespace

std::variant<Options, ExitCode> read_command_line(int argc, char** argv) {
    Options options;
    Typed typed;
    std::string shell_folder;
    CLI::App app("The Glift compiler: GPU data structures to GLSL, SPIR-V and C++.", "gliftc");
    app.set_version_flag("--version", "gliftc " + std::string(version()));
    app.get_formatter()->column_width(34);
    app.footer(
        "@FILE is replaced by the arguments in FILE. NO_COLOR in the environment turns colours off.\n"
        "Exit status: 0 done, 1 errors in the source, a file that cannot be read or tests that fail, 2 wrong usage,\n"
        "3 a bug in gliftc, 4 a file that cannot be written or a program that is not there.");
    app.add_option("files", options.files, "The files to compile; '-' is standard input")->type_name("FILE");
    add_output_options(app, options, typed);
    add_input_options(app, options, typed);
    add_stage_options(app, options, typed);
    add_diagnostics_options(app, options, typed);
    add_test_command(app, options);
    add_watch_command(app, options);
    add_explain_command(app, options);
    add_format_command(app, options);
    add_new_command(app, options);
    add_server(app, options);
    add_hidden_command(app, shell_folder);
    app.require_subcommand(0, 1);
    try {
        std::vector<std::string> words(argv + 1, argv + argc);
        if (std::string error = expand_response_files(words, disk()); !error.empty())
            throw CLI::ValidationError("@FILE", error);
        translate_customs(words);
        std::reverse(words.begin(), words.end());  // the order that CLI11 expects
        app.parse(std::move(words));
        finish(options, typed);
        if (!shell_folder.empty()) {
            write_shell_files(app, std::string(version()), shell_folder);
            return ExitCode::done;
        }
        if (options.command == Command::make_project) return options;
        if (options.files.empty() && options.command != Command::lsp) throw CLI::RequiredError("a file");
        check_combinations(options);
    } catch (const CLI::ParseError& error) {
        bool asked = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
        app.exit(error);
        return asked ? ExitCode::done : ExitCode::wrong_usage;
    }
    return options;
}

}  // namespace gliftc
