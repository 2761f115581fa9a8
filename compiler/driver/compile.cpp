#include "driver/compile.h"

#include "driver/declarations.h"
#include "driver/emit.h"
#include "driver/import_structs.h"
#include "ir/print.h"
#include "layout/layout.h"
#include "layout/nesting.h"
#include "layout/private_memory.h"
#include "lower/library.h"
#include "lower/lower.h"
#include "syntax/print.h"

#include <chrono>
#include <filesystem>

namespace gliftc {

namespace {

/// Measures how long each stage takes.
class Stopwatch {
public:
    explicit Stopwatch(std::vector<StageTime>& times) : times_(times) {}
    void lap(std::string_view stage) {
        auto now = std::chrono::steady_clock::now();
        times_.push_back({stage, std::chrono::duration<double, std::milli>(now - before_).count()});
        before_ = now;
    }

private:
    std::vector<StageTime>& times_;
    std::chrono::steady_clock::time_point before_ = std::chrono::steady_clock::now();
};

std::string dump_syntax(const Compilation& c) {
    std::string text;
    for (const sema::LoadedModule& module : c.loaded.modules)
        if (module.is_root) text += print(*module.tree, c.tree, c.names);
    return text;
}

/// In a Makefile, a space ends a name, '#' begins a comment and '$' a variable.
std::string escape_for_make(std::string_view path) {
    std::string escaped;
    for (char c : path) {
        if (c == ' ' || c == '#') escaped += '\\';
        if (c == '$') escaped += '$';
        escaped += c;
    }
    return escaped;
}

}  // namespace

Result compile(const Options& options, const FileSystem& files, Compilation& c) {
    Result result;
    Stopwatch clock(result.times);
    // A module whose name does not match its file (`misnamed` counts such errors) is checked all the same.
    auto has_errors = [&] { return c.diagnostics.error_count() > c.loaded.misnamed; };
    auto stops_after = [&](Stage stage) { return has_errors() || options.stops_after(stage); };

    check_style(options, c.diagnostics);
    if (std::filesystem::is_regular_file(options.style)) c.read_files.push_back(options.style);
    c.loaded = load_modules(options, files, c.sources, c.names, c.tree, c.diagnostics);
    clock.lap("syntax");
    if (options.dump == Stage::syntax) result.dump = dump_syntax(c);
    if (stops_after(Stage::syntax)) return result;

    import_structs(options, files, c);
    clock.lap("import");
    if (has_errors()) return result;

    c.program = sema::check(
        c.loaded.modules, c.tree, c.names, c.diagnostics,
        {.defines = options.defines,
         .looks_into_tables = options.command == Command::test,
         .messages = options.messages,
         .source_text = [&](Span span) { return c.sources.text(span); },
         .module_with = [&](std::string_view name) { return module_with_declaration(options, files, name); }});
    clock.lap("sema");
    if (options.dump == Stage::sema) result.dump = ir::print(c.program);
    if (stops_after(Stage::sema) || c.diagnostics.has_errors()) return result;

    lower::Trace trace{options.dump_after, options.stop_after_pass, {}};
    c.lowered = lower::lower(c.program, c.diagnostics,
                             {options.checked ? lower::Checks::ranges : lower::Checks::none,
                              options.address_bits == 64 ? lower::AddressBits::b64 : lower::AddressBits::b32,
                              trace.is_on() ? &trace : nullptr});
    result.dump += trace.text;
    if (trace.is_on()) return result;
    if (options.wants(Target::glsl)) c.lowered.libraries = lower::lower_libraries(c.program, c.diagnostics);
    clock.lap("lower");
    if (stops_after(Stage::lower) && options.dump != Stage::lower) return result;

    layout::lay_out(c.program, c.lowered);
    layout::check_private_memory(c.program, c.lowered, c.diagnostics);
    layout::check_nesting(c.program, c.lowered, c.diagnostics);
    clock.lap("layout");
    if (options.dump == Stage::lower || options.dump == Stage::layout) result.dump = ir::print(c.program, c.lowered);
    if (stops_after(Stage::layout) || options.dump || options.check_only || options.command == Command::explain)
        return result;

    result.outputs = emit(options, c);
    clock.lap("emit");
    return result;
}

Diagnostics check_text(std::string_view text) {
    Options options;
    options.files = {"input.glift"};
    Compilation compilation;
    compile(options, only_text(std::string(text)), compilation);
    return std::move(compilation.diagnostics);
}

std::string make_depfile(const Options& options, const Result& result, const Compilation& compilation) {
    std::string rule;
    for (const Output& output : result.outputs) {
        std::string path = options.output_folder == "." ? output.name : options.output_folder + "/" + output.name;
        rule += (rule.empty() ? "" : " ") + escape_for_make(path);
    }
    rule += ":";
    for (std::uint32_t file = 0; file < compilation.sources.size(); ++file)
        if (compilation.sources[file].path != "<stdin>")
            rule += " \\\n  " + escape_for_make(compilation.sources[file].path);
    for (const std::string& path : compilation.read_files) rule += " \\\n  " + escape_for_make(path);
    return rule + "\n";
}

}  // namespace gliftc
