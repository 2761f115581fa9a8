// The names that generated code in one namespace uses for what a program declares.
#include "emit/cpp/printer.h"

#include <algorithm>

namespace gliftc::cpp {

namespace {

/// Functions of the runtime that argument-dependent lookup would find for arguments of its types: vectors, arrays,
/// bools in memory (glift::Bool).
const NameSet& functions_of_runtime() {
#define INTRINSIC(name, signature, exactness) #name,
    static const NameSet names = {
#include "ir/intrinsics.def"
        "as_array",      "assign_swizzle", "bytes_of",   "convert",      "cube_extent", "divide",    "divisor",
        "element_count", "half_bits",      "half_value", "image_extent", "minor_of",    "remainder", "reset",
        "shift_left",    "shift_right",    "spread",     "subtract",     "swizzle",     "tried",
    };
#undef INTRINSIC
    return names;
}

/// The index of the alias by which a module calls the structure: the module's first public one, else another of its
/// own, else a public one of a module that it imports. The number of aliases if there is none.
std::size_t alias_in(const ir::Program& program, const ir::Structure& structure, ir::ModuleId module) {
    enum Rank { own_public, own, imported, foreign };
    const auto rank_of = [&](const ir::Alias& alias) {
        if (alias.module == module) return alias.is_pub ? own_public : own;
        return is_alias_seen(program, alias, module) ? imported : foreign;
    };
    const auto best = std::ranges::min_element(structure.aliases, {}, rank_of);  // the first of several
    return best == structure.aliases.end() || rank_of(*best) == foreign
               ? structure.aliases.size()
               : static_cast<std::size_t>(best - structure.aliases.begin());
}

}  // namespace

bool is_alias_seen(const ir::Program& program, const ir::Alias& alias, ir::ModuleId module) {
    return alias.module == module ||
           (alias.is_pub && std::ranges::binary_search(program.modules[module].imports, alias.module));
}

Globals make_globals(const ir::Program& program, const Sources& sources, const ProgramNames& names, Surroundings at) {
    Globals globals(program, sources);
    const auto spelled = [&](ir::ModuleId module, const std::string& name) {
        return module == at.home ? name : "::" + names.spaces[module] + "::" + name;
    };
    globals.space = names.spaces[at.home];
    globals.names.avoid(names.taken[at.home].used());
    globals.type_names = names.types[at.home];
    globals.field_names = names.fields;
    globals.class_names = names.classes;
    for (ir::StructId i : program.structs.ids()) {
        const ir::Struct& each = program.structs[i];
        globals.struct_names.push_back(each.extern_name.empty() ? spelled(each.module, names.structs[i])
                                                                : "::" + each.extern_name);
    }
    for (ir::StructureId i : program.structures.ids()) {
        const ir::Structure& each = program.structures[i];
        const std::size_t alias = at.root == at.home ? alias_in(program, each, at.root) : each.aliases.size();
        globals.structure_names.push_back(alias < each.aliases.size()
                                              ? spelled(each.aliases[alias].module, names.aliases[i][alias])
                                              : spelled(each.module, names.structures[i]));
    }
    for (ir::KernelId i : program.kernels.ids())
        globals.kernel_names.push_back(spelled(program.kernels[i].module, names.kernels[i]));
    for (ir::PipelineId i : program.pipelines.ids()) {
        const ir::Pipeline& each = program.pipelines[i];
        globals.pipeline_names.push_back(each.owner ? names.pipelines[i] : spelled(each.module, names.pipelines[i]));
    }
    return globals;
}

std::string declare_function(Globals& globals, ir::FunctionId function) {
    std::string name = identifier((*globals.program.names)[globals.program.functions[function].name]);
    if (functions_of_runtime().contains(name)) name += '_';
    return globals.names.declare(name);
}

std::vector<std::string> block_names(const Globals& globals, const ir::Pass& pass) {
    Scopes scopes;
    scopes.avoid(globals.type_names);
    std::vector<std::string> names;
    for (const ir::PassParameter& parameter : pass.parameters) names.push_back(scopes.declare(parameter.name));
    return names;
}

}  // namespace gliftc::cpp
