#include "emit/cpp/unit.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace gliftc::cpp {

void reserve_locals_of_calls(Scopes& names) { names.reserve({"commands", "iteration", "memories", "parameters"}); }

namespace {

constexpr std::size_t kernels_of_a_thread = 16;  ///< printing fewer takes less time than starting a thread

/// Names the parameters of a kernel's generated function. The names differ from those of the function's own variables.
void name_parameters(Unit& unit, const ir::Kernel& kernel) {
    Scopes names;
    names.avoid(unit.globals.type_names);
    names.avoid(unit.globals.kernel_symbols);
    reserve_locals_of_calls(names);
    for (const ir::KernelParam& param : kernel.params)
        unit.globals.param_names[&param] = names.declare(unit.name(param.name));
}

/// Names what is made for each kernel beside its function: its code, and the data that describes it.
void name_symbols(Unit& unit) {
    static constexpr const char* suffixes[] = {
        "_bindings",     "_colours",          "_direct_fragment_spirv",  "_direct_spirv",  "_drawing",
        "_general",      "_general_fragment", "_general_fragment_spirv", "_general_group", "_general_parameters",
        "_general_rows", "_general_spirv",    "_general_vertex",         "_kernel",        "_other_files",
        "_parameters"};
    Globals& globals = unit.globals;
    for (ir::KernelId kernel : unit.reach.kernels) {
        if (unit.program.kernels[kernel].module != unit.home) continue;
        const std::string stem = globals.names.declare_stem(unit.own.kernels[kernel], suffixes);
        for (const char* suffix : suffixes) globals.kernel_symbols.insert(stem + suffix);
        globals.kernel_stems[kernel] = stem;
    }
}

}  // namespace

const char* Unit::linkage(const std::string& key) const {
    return home == module && key.find('<') == std::string::npos ? "" : "GLIFT_SHARED ";
}

ir::StructureId structure_at(const ir::Program& program, ir::StructureId structure, const ir::Place& place) {
    for (std::uint32_t member : place.members) structure = program.structures[structure].members[member].structure;
    return structure;
}

Unit make_unit(const ModuleParts& parts, ir::ModuleId home) {
    Unit unit{parts.program,
              parts.lowered,
              parts.sources,
              parts.module,
              home,
              parts.code,
              parts.options,
              parts.reach,
              parts.names,
              make_globals(parts.program, parts.sources, parts.names, {parts.module, home}),
              {}};
    name_symbols(unit);
    for (ir::KernelId kernel : parts.reach.kernels)
        if (parts.program.kernels[kernel].module == home) name_parameters(unit, parts.program.kernels[kernel]);
    return unit;
}

std::vector<std::string> printed_kernels(Unit& unit, const std::vector<ir::KernelId>& kernels,
                                         bool (&adds_functions)(const Unit&, ir::KernelId),
                                         std::string (&print)(Unit&, ir::KernelId)) {
    std::vector<std::string> texts(kernels.size());
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < kernels.size(); ++i) {
        if (adds_functions(unit, kernels[i])) texts[i] = print(unit, kernels[i]);
        else others.push_back(i);
    }
    for_each_parallel(others.size(), kernels_of_a_thread,
                      [&](std::size_t i) { texts[others[i]] = print(unit, kernels[others[i]]); });
    return texts;
}

std::string file_stem(const ir::Program& program, const Sources& sources, ir::ModuleId module) {
    const std::string& path = sources[program.modules[module].file].path;
    if (path != "<stdin>") return std::filesystem::path(path).stem().string();
    const std::string& name = (*program.names)[program.modules[module].name];
    return name.substr(name.rfind('.') + 1);
}

std::string begin_of_file(const std::string& stem) {
    return "// Made by gliftc from " + stem + ".glift. Changes are lost when it is made again.";
}

}  // namespace gliftc::cpp
