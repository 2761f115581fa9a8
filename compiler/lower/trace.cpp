#include "lower/trace.h"

#include "base/concat.h"
#include "ir/print.h"
#include "ir/walk.h"

#include <algorithm>
#include <iterator>

namespace gliftc::lower {

namespace {

/// Whether the invocation's address is the only local in a fact: others are declared in the body, and a fact is printed
/// before it.
bool is_of_address(const ir::Program& program, const ir::Pass& pass, ir::ExprId fact) {
    bool found = true;
    ir::for_each_node(program, fact, [&](ir::ExprId id) {
        const ir::Expr& node = program.exprs[id];
        if (node.op == ir::Op::local && node.local != pass.address) found = false;
    });
    return found;
}

}  // namespace

void Trace::note(std::string_view pass_name, const ir::Program& program, const ir::Pass& pass,
                 const std::vector<ir::Variant>& variants, const std::vector<ir::ExprId>& facts,
                 std::string_view what) {
    if (pass_name != dump_after || !pass.kernel) return;
    if (!program.modules[program.kernels[pass.kernel].module].is_root) return;
    ir::Pass shown = pass;
    shown.prologue.clear();
    shown.variants = variants;
    std::vector<ir::ExprId> shown_facts;
    for (ir::ExprId fact : facts)
        if (is_of_address(program, pass, fact)) shown_facts.push_back(fact);
    text += concat("// ", what, ", after ", pass_name, "\n", ir::print(program, shown, shown_facts), "\n");
}

void Trace::note(std::string_view pass_name, const ir::Program& program, const std::vector<ir::FunctionId>& functions) {
    if (pass_name != dump_after) return;
    for (ir::ModuleId module : program.modules.ids()) {
        const auto kernel = std::ranges::find(program.kernels, module, &ir::Kernel::module);
        if (!program.modules[module].is_root || kernel == program.kernels.end()) continue;
        ir::Pass shown;
        shown.kernel = program.kernels.id_of(*kernel);
        std::ranges::copy_if(functions, std::back_inserter(shown.functions),
                             [&](ir::FunctionId id) { return program.functions[id].module == module; });
        if (shown.functions.empty()) continue;
        text += concat("// functions, after ", pass_name, "\n", ir::print(program, shown), "\n");
    }
}

}  // namespace gliftc::lower
