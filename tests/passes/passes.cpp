#include "passes.h"

#include "driver/compile.h"
#include "ir/print.h"
#include "ir/read.h"
#include "ir/validate.h"
#include "ir/walk.h"
#include "lower/host/find_rows.h"
#include "lower/host/lockstep.h"
#include "lower/host/row_updates.h"
#include "lower/passes.h"
#include "lower/transform/uniforms.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace gliftc::test {

namespace {

constexpr std::string_view line_between = "---\n";

/// A kernel in the middle of lowering, read from its text. The context is created before the nodes are read, so that
/// it takes them for nodes of the pass.
struct Lowering {
    Names names;
    ir::Program program;
    Diagnostics diagnostics;
    ir::Kernel kernel;
    ir::Pass pass;
    std::vector<ir::ExprId> facts;
    lower::Context cx;

    explicit Lowering(const std::string& text) : cx(with_names(program, names), kernel, pass, diagnostics, {}) {
        std::vector<ir::ReadPass> read = ir::read_passes(program, text);
        if (read.size() != 1) throw std::runtime_error("a case has one pass");
        pass = std::move(read[0].pass);
        facts = std::move(read[0].facts);
        kernel = program.kernels[pass.kernel];
        ir::for_each_statement(program, pass.plain().body, [&](const ir::Stmt& stmt) {
            const bool is_definition = stmt.op == ir::StmtOp::let && stmt.value;
            if (is_definition && !program.locals[stmt.local].is_mutable) cx.definitions[stmt.local] = stmt.value;
        });
    }
    static ir::Program& with_names(ir::Program& program, Names& names) {
        program.names = &names;
        return program;
    }
};

void run(Lowering& lowering, const std::string& name) {
    for (const lower::BodyPass& pass : lower::body_passes()) {
        if (pass.name != name) continue;
        lowering.pass.plain().body = pass.run(lowering.cx, lowering.pass.plain().body, lowering.facts);
        return;
    }
    for (const lower::BodyPass& pass : lower::host_passes()) {
        if (pass.name != name) continue;
        ir::Variant& variant = lowering.pass.plain();
        variant = {variant.part, ir::Devices::host, variant.assumes,
                   pass.run(lowering.cx, variant.body, lowering.facts)};
        return;
    }
    if (name == "lockstep") {
        ir::Variant& variant = lowering.pass.plain();
        variant.devices = ir::Devices::host;
        if (auto body = lower::in_lockstep(lowering.cx, variant.body)) variant.body = std::move(*body);
        return;
    }
    if (name == "find_rows") {
        lowering.pass.variants = lower::find_rows(lowering.cx, lowering.pass.plain());
        return;
    }
    if (name == "find_row_updates") {
        ir::Variant& variant = lowering.pass.plain();
        variant.devices = ir::Devices::host;
        return lower::find_row_updates(lowering.cx, variant);
    }
    if (name != "move_uniforms") throw std::runtime_error("there is no pass over bodies that is called '" + name + "'");
    lower::move_uniforms(lowering.cx, {&lowering.pass.plain().body});
}

/// What gliftc --dump-after=PASS prints of the kernels of a file.
std::string dumped(const std::filesystem::path& path, const std::string& pass) {
    if (!lower::is_pass(pass)) throw std::runtime_error("there is no pass that is called '" + pass + "'");
    Options options;
    options.files = {path.string()};
    options.library_folder = GLIFT_SOURCE_DIR "/stdlib";
    options.dump_after = options.stop_after_pass = pass;
    Compilation compilation;
    Result result = compile(options, disk(), compilation);
    if (compilation.diagnostics.has_errors()) throw std::runtime_error("the kernels have errors: gliftc shows them");
    return std::move(result.dump);
}

bool is_source(const std::filesystem::path& path) { return path.extension() == ".glift"; }

std::filesystem::path after(std::filesystem::path path) { return path.replace_extension(".after"); }

std::string read_file(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

void write_file(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

}  // namespace

std::vector<std::filesystem::path> pass_cases() {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GLIFT_SOURCE_DIR "/tests/passes"))
        if (entry.path().extension() == ".ir" || is_source(entry.path())) found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

PassCase read_pass_case(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    if (is_source(path)) return {text, read_file(after(path))};
    const std::size_t line = text.find(line_between);
    if (line == std::string::npos) return {text, ""};
    return {text.substr(0, line), text.substr(line + line_between.size())};
}

void write_pass_case(const std::filesystem::path& path, const PassCase& pass_case) {
    if (is_source(path)) write_file(after(path), pass_case.after);
    else write_file(path, pass_case.before + std::string(line_between) + pass_case.after);
}

std::string run_pass(const std::filesystem::path& path, const std::string& before) {
    const std::string name = path.parent_path().filename().string();
    if (is_source(path)) return dumped(path, name);
    Lowering lowering(before);
    run(lowering, name);
    for (const std::string& problem :
         ir::validate(lowering.program, lowering.pass, ir::statements_of(lowering.pass.plain()), {}))
        throw std::runtime_error(problem);
    return ir::print(lowering.program, lowering.pass);
}

}  // namespace gliftc::test
