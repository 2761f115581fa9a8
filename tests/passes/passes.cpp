#include "passes.h"

#include "ir/print.h"
#include "ir/read.h"
#include "ir/validate.h"
#include "ir/walk.h"
#include "lower/passes.h"
#include "lower/uniforms.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace gliftc::test {

namespace {

constexpr std::string_view line_between = "---\n";

/// A kernel that is being lowered, from the text of its pass. The context is made before there are nodes: what the text
/// has belongs to the pass.
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
        ir::for_each_statement(program, pass.body, [&](const ir::Stmt& stmt) {
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
        lowering.pass.body = pass.run(lowering.cx, lowering.pass.body, lowering.facts);
        return;
    }
    if (name != "move_uniforms") throw std::runtime_error("there is no pass over bodies that is called '" + name + "'");
    lower::move_uniforms(lowering.cx, {&lowering.pass.body});
}

}  // namespace

std::vector<std::filesystem::path> pass_cases() {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GLIFT_SOURCE_DIR "/tests/passes"))
        if (entry.path().extension() == ".ir") found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

PassCase read_pass_case(const std::filesystem::path& path) {
    std::ostringstream whole;
    whole << std::ifstream(path, std::ios::binary).rdbuf();
    const std::string text = whole.str();
    const std::size_t line = text.find(line_between);
    if (line == std::string::npos) return {text, ""};
    return {text.substr(0, line), text.substr(line + line_between.size())};
}

std::string text_of(const PassCase& pass_case) {
    return pass_case.before + std::string(line_between) + pass_case.after;
}

std::string run_pass(const std::filesystem::path& path, const std::string& before) {
    Lowering lowering(before);
    run(lowering, path.parent_path().filename().string());
    for (const std::string& problem : ir::validate(lowering.program, lowering.pass, lowering.pass.body, {}))
        throw std::runtime_error(problem);
    return ir::print(lowering.program, lowering.pass);
}

}  // namespace gliftc::test
