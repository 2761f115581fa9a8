// A module's headers and sources, put together from their parts.
//
//   <name>.glift.hpp                  what a program sees: public classes and functions, and classes of other modules
//                                     that these name
//   <name>.glift.types.hpp            the structs and enums that the other files need
//   <name>.glift.internal.hpp         what .glift.cpp and .glift.library.cpp see: hidden classes and functions
//   <name>.glift.cpp                  the module's own pipelines, members of classes, and functions that call kernels
//   <name>.glift.library.cpp          the same for other modules, except what another source defines
//   <name>.glift.kernels.cpp          the code of the module's own kernels (kernel_sources.cpp)
//   <name>.glift.library.kernels.cpp  the code of kernels of other modules
//
// With several shards there are also .glift.kernels.2.cpp and so on, and with Options::spirv_files .spirv files beside
// the sources of kernels.
//
// Several headers may define a class: an #ifndef of its name skips all definitions but the first. Of the sources of one
// run, one defines the function of a kernel or pipeline, or the members of a class (cpp::Defined); the sources of a
// test program define all that it uses. Instances of generics and functions of other modules are weak symbols, so that
// sources of other runs may define them, too.
#include "base/version.h"
#include "emit/cpp/reloadable.h"
#include "emit/cpp/spaces.h"
#include "emit/cpp/unit.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace gliftc::cpp {

namespace {

/// Prints all files of one module.
class ModulePrinter {
public:
    ModulePrinter(const ir::Program& program, const ir::Lowered& lowered, const Sources& sources, ir::ModuleId module,
                  const KernelCodes& code, const Options& options, Defined& defined);

    Module print();

private:
    Unit& unit_of(ir::ModuleId home);
    bool has_source(ir::ModuleId module) const;
    bool is_shown(ir::PipelineId pipeline) const;
    bool is_declared_elsewhere(bool is_pub, const std::string& key, ir::ModuleId module) const;
    void find_shown_elsewhere();
    void name_by_devices();

    template <class Print>
    void print_once(Writer& out, Spaces& spaces, ir::ModuleId home, const std::string& name, const Print& print);
    void print_types(Writer& out, Spaces& spaces);
    void print_classes(Writer& out, Spaces& spaces, bool (ModulePrinter::*wanted)(ir::StructureId) const);
    void print_aliases(Writer& out, Spaces& spaces, ir::StructureId structure);
    void announce_classes(Writer& out, Spaces& spaces, ir::StructureId structure, std::set<ir::StructureId>& known);
    bool is_in_header(ir::StructureId structure) const { return reach_.in_header.contains(structure); }
    bool is_hidden(ir::StructureId structure) const { return !is_in_header(structure); }
    std::string stem_of(ir::ModuleId module) const { return file_stem(program_, sources_, module); }
    void print_headers(Writer& out, const std::string& ending) const;
    void print_functions_shown(Writer& out);
    void print_functions_hidden(Writer& out, Spaces& spaces);
    void print_definitions(Unit& unit, Writer& out);
    void note_definitions();

    std::string header();
    std::string types_header();
    std::string internal_header();
    std::string source();
    std::string library_source();
    void print_includes(Writer& out) const;
    std::vector<ir::KernelId> kernels_to_define(bool own) const;

    const ir::Program& program_;
    const ir::Lowered& lowered_;
    const Sources& sources_;
    ir::ModuleId module_;
    const KernelCodes& code_;
    const Options& options_;
    Defined& defined_;
    Reach reach_;
    Reach elsewhere_;  ///< the types and classes of the headers that this module's header includes
    ProgramNames names_;
    const ModuleParts parts_;
    std::map<ir::ModuleId, Unit> units_;
    const std::string stem_;
};

ModulePrinter::ModulePrinter(const ir::Program& program, const ir::Lowered& lowered, const Sources& sources,
                             ir::ModuleId module, const KernelCodes& code, const Options& options, Defined& defined)
    : program_(program), lowered_(lowered), sources_(sources), module_(module), code_(code), options_(options),
      defined_(defined), reach_(reach_of(program, module, options)),
      names_(program_names(program)), parts_{program, lowered, sources, module, code, options, reach_, names_},
      stem_(file_stem(program, sources, module)) {
    add_inner_structs(reach_, program, lowered);
    find_shown_elsewhere();
    name_by_devices();
}

/// Adds the kind of device to the names of functions that other runs of gliftc may define, too, and for which this run
/// has code for one kind of device only (host, Vulkan) or for none: the linker must not take one for the other.
void ModulePrinter::name_by_devices() {
    const auto is_shared = [&](const std::string& key, ir::ModuleId home) {
        return key.find('<') != std::string::npos || !has_source(home);
    };
    const auto rename = [&](std::string& name, ir::ModuleId home, bool host, bool vulkan) {
        if (host && vulkan) return;
        name = names_.taken[home].declare(name + (host ? "_on_host" : vulkan ? "_on_vulkan" : "_on_none"));
    };
    for (ir::KernelId index : reach_.kernels)
        if (const ir::Kernel& kernel = program_.kernels[index]; is_shared(kernel.key, kernel.module))
            rename(names_.kernels[index], kernel.module, reach_.host_kernels.contains(index),
                   reach_.vulkan_kernels.contains(index));
    for (ir::PipelineId index : reach_.pipelines)
        if (const ir::Pipeline& pipeline = program_.pipelines[index];
            !pipeline.owner && is_shared(pipeline.key, pipeline.module))
            rename(names_.pipelines[index], pipeline.module, reach_.host_pipelines.contains(index),
                   reach_.vulkan_pipelines.contains(index));
}

/// Whether this run makes sources for the module itself. A test program has only those of the module with the tests.
bool ModulePrinter::has_source(ir::ModuleId module) const {
    return module == module_ || (program_.modules[module].is_root && !options_.tests);
}

void ModulePrinter::find_shown_elsewhere() {
    for (ir::ModuleId import : program_.modules[module_].imports) {
        if (import == module_ || !has_source(import)) continue;
        const Reach shown = reach_of(program_, import, options_);
        elsewhere_.in_header.insert(shown.in_header.begin(), shown.in_header.end());
        elsewhere_.enums.insert(shown.enums.begin(), shown.enums.end());
        elsewhere_.structs.insert(elsewhere_.structs.end(), shown.structs.begin(), shown.structs.end());
    }
}

Unit& ModulePrinter::unit_of(ir::ModuleId home) {
    if (const auto found = units_.find(home); found != units_.end()) return found->second;
    return units_.emplace(home, make_unit(parts_, home)).first->second;
}

bool ModulePrinter::is_shown(ir::PipelineId pipeline) const {
    const ir::Pipeline& p = program_.pipelines[pipeline];
    return p.is_pub && p.module == module_ && !p.owner && !options_.tests;
}

/// Whether a header that this module's header includes declares the kernel or pipeline.
bool ModulePrinter::is_declared_elsewhere(bool is_pub, const std::string& key, ir::ModuleId module) const {
    return is_pub && module != module_ && has_source(module) && key.find('<') == std::string::npos;
}

template <class Print> void ModulePrinter::print_once(Writer& out, Spaces& spaces, ir::ModuleId home,
                                                      const std::string& name, const Print& print) {
    Unit& unit = unit_of(home);
    spaces.enter(unit.globals.space);
    const std::string guard = "GLIFT_" + unit.globals.space + "_HAS_" + name;
    out.raw("#ifndef " + guard + "\n#define " + guard + "\n");
    Writer text;
    print(unit, text);
    std::string body = text.take();
    while (body.ends_with("\n\n")) body.pop_back();
    out.raw(body + "#endif\n");
    out.gap();
}

void ModulePrinter::print_types(Writer& out, Spaces& spaces) {
    for (ir::EnumId index : reach_.enums) {
        const ir::Enum& type = program_.enums[index];
        if (elsewhere_.enums.contains(index)) continue;
        print_once(out, spaces, type.module, names_.enums[index],
                   [&](Unit& unit, Writer& text) { print_enum(unit, text, index); });
    }
    for (ir::StructId index : reach_.structs) {
        const ir::Struct& type = program_.structs[index];
        if (std::ranges::find(elsewhere_.structs, index) != elsewhere_.structs.end()) continue;
        print_once(out, spaces, type.module, names_.structs[index],
                   [&](Unit& unit, Writer& text) { print_struct(unit, text, index); });
    }
}

/// Declares the aliases of a structure that the module may use. Those of other modules for which this run makes a
/// header are left out: that header declares them.
void ModulePrinter::print_aliases(Writer& out, Spaces& spaces, ir::StructureId index) {
    const ir::Structure& structure = program_.structures[index];
    for (std::size_t i = 0; i < structure.aliases.size(); ++i) {
        const ir::Alias& alias = structure.aliases[i];
        if (!is_alias_seen(program_, alias, module_) || (alias.module != module_ && has_source(alias.module))) continue;
        const bool is_at_home = alias.module == structure.module;
        if (is_at_home && names_.aliases[index][i] == names_.structures[index]) continue;
        spaces.enter(names_.spaces[alias.module]);
        out.line("using " + names_.aliases[index][i] + " = " +
                 (is_at_home ? "" : "::" + names_.spaces[structure.module] + "::") + names_.structures[index] + ";");
        out.gap();
    }
}

/// Declares the classes, not in `known`, that the signatures of a structure's pipelines name: its own, and those that
/// name it in turn.
void ModulePrinter::announce_classes(Writer& out, Spaces& spaces, ir::StructureId index,
                                     std::set<ir::StructureId>& known) {
    for (ir::PipelineId pipeline : program_.structures[index].pipelines) {
        for (const ir::PipelineParam& param : program_.pipelines[pipeline].params) {
            if (!param.structure || elsewhere_.in_header.contains(param.structure)) continue;
            if (!known.insert(param.structure).second) continue;
            spaces.enter(unit_of(program_.structures[param.structure].module).globals.space);
            out.line("class " + names_.structures[param.structure] + ";");
            out.gap();
            print_aliases(out, spaces, param.structure);
        }
    }
}

void ModulePrinter::print_classes(Writer& out, Spaces& spaces, bool (ModulePrinter::*wanted)(ir::StructureId) const) {
    std::set<ir::StructureId> known;
    for (ir::StructureId index : reach_.structures) {
        if (!(this->*wanted)(index)) {
            known.insert(index);
            continue;
        }
        announce_classes(out, spaces, index, known);
        known.insert(index);
        const ir::Structure& structure = program_.structures[index];
        if (!elsewhere_.in_header.contains(index))
            print_once(out, spaces, structure.module, names_.structures[index],
                       [&](Unit& unit, Writer& text) { print_class(unit, text, index); });
        print_aliases(out, spaces, index);
    }
}

void ModulePrinter::print_functions_shown(Writer& out) {
    Unit& unit = unit_of(module_);
    for (ir::KernelId kernel : reach_.kernels) {
        if (!reach_.pub_kernels.contains(kernel)) continue;
        write_doc(out, program_.kernels[kernel].doc);
        out.line(kernel_signature(unit, kernel, true) + ";");
        if (range_of_first_at(program_.kernels[kernel])) out.line(kernel_signature(unit, kernel, true, 1) + ";");
        out.gap();
    }
    for (ir::PipelineId pipeline : reach_.pipelines) {
        if (!is_shown(pipeline)) continue;
        write_doc(out, program_.pipelines[pipeline].doc);
        out.line(pipeline_signature(unit, pipeline, true) + ";");
        out.gap();
    }
}

void ModulePrinter::print_functions_hidden(Writer& out, Spaces& spaces) {
    for (ir::KernelId index : reach_.kernels) {
        const ir::Kernel& kernel = program_.kernels[index];
        if (reach_.pub_kernels.contains(index) || is_declared_elsewhere(kernel.is_pub, kernel.key, kernel.module))
            continue;
        Unit& unit = unit_of(kernel.module);
        spaces.enter(unit.globals.space);
        out.line(kernel_signature(unit, index, true) + ";");
    }
    for (ir::PipelineId index : reach_.pipelines) {
        const ir::Pipeline& pipeline = program_.pipelines[index];
        if (pipeline.owner || is_shown(index) || is_declared_elsewhere(pipeline.is_pub, pipeline.key, pipeline.module))
            continue;
        Unit& unit = unit_of(pipeline.module);
        spaces.enter(unit.globals.space);
        out.line(pipeline_signature(unit, index, true) + ";");
    }
}

/// Includes the headers of the modules that this one uses, if the same run makes them.
void ModulePrinter::print_headers(Writer& out, const std::string& ending) const {
    std::set<std::string> headers;
    for (ir::ModuleId import : program_.modules[module_].imports)
        if (import != module_ && has_source(import)) headers.insert(stem_of(import) + ending);
    for (const std::string& header : headers) out.line("#include \"" + header + "\"");
}

/// Asserts that the runtime's headers are of this compiler's version (<glift/version.h>).
void print_version_check(Writer& out) {
    const std::string major(major_version()), minor(minor_version());
    out.line("static_assert(GLIFT_VERSION_MAJOR == " + major + " && GLIFT_VERSION_MINOR == " + minor + ",");
    out.line("              \"gliftc " + major + "." + minor +
             " made this, and the Glift headers found are of another version: \"");
    out.line("              \"run the gliftc that belongs to them, or compile with the headers and library of \"");
    out.line("              \"Glift " + major + "." + minor + "\");");
}

std::string ModulePrinter::header() {
    Writer out;
    out.line(begin_of_file(stem_));
    out.line("#pragma once");
    out.gap();
    out.line("#include \"" + stem_ + ".glift.types.hpp\"");
    print_headers(out, ".glift.hpp");
    out.gap();
    out.line("#include <glift/glift.h>");
    out.line("#include <glift/structure.h>");
    out.gap();
    print_version_check(out);
    out.gap();
    write_doc(out, program_.modules[module_].doc);
    Spaces spaces(out);
    print_classes(out, spaces, &ModulePrinter::is_in_header);
    Writer functions;
    print_functions_shown(functions);
    if (!functions.text().empty()) {
        spaces.enter(unit_of(module_).globals.space);
        out.raw(functions.text());
    }
    spaces.leave();
    return out.take();
}

std::string ModulePrinter::types_header() {
    Writer out;
    out.line(begin_of_file(stem_));
    out.line("#pragma once");
    out.gap();
    print_headers(out, ".glift.types.hpp");
    std::set<std::string> headers;
    for (ir::StructId index : reach_.structs)
        if (const std::string& header = program_.structs[index].extern_header; !header.empty()) headers.insert(header);
    for (const std::string& header : headers) out.line("#include \"" + header + "\"");
    out.gap();
    out.line("#include <glift/vector.h>");
    out.gap();
    out.line("#include <cstddef>");
    out.line("#include <optional>");
    out.gap();
    Spaces spaces(out);
    print_types(out, spaces);
    spaces.leave();
    return out.take();
}

std::string ModulePrinter::internal_header() {
    Writer out;
    out.line(begin_of_file(stem_));
    out.line("#pragma once");
    out.gap();
    out.line("#include \"" + stem_ + ".glift.hpp\"");
    if (options_.tests) {
        out.gap();
        out.line("#include <glift/translation_checks.h>");
    }
    out.gap();
    Spaces spaces(out);
    print_classes(out, spaces, &ModulePrinter::is_hidden);
    print_functions_hidden(out, spaces);
    spaces.leave();
    return out.take();
}

void ModulePrinter::print_includes(Writer& out) const {
    out.line(begin_of_file(stem_));
    out.line("#include \"" + stem_ + ".glift.internal.hpp\"");
    out.gap();
    out.line("#include <glift/host/math.h>");
    if (options_.reload) out.line("#include <glift/reload.h>");
    out.gap();
    out.line("#include <cstddef>");
    out.line("#include <optional>");
    out.gap();
}

std::vector<ir::KernelId> ModulePrinter::kernels_to_define(bool own) const {
    std::vector<ir::KernelId> kernels;
    for (ir::KernelId kernel : reach_.kernels)
        if ((program_.kernels[kernel].module == module_) == own && !defined_.kernels.contains(kernel))
            kernels.push_back(kernel);
    return kernels;
}

/// The definitions of one namespace in this source.
void ModulePrinter::print_definitions(Unit& unit, Writer& out) {
    std::vector<ir::KernelId> kernels = kernels_to_define(unit.home == module_);
    std::erase_if(kernels, [&](ir::KernelId kernel) { return program_.kernels[kernel].module != unit.home; });
    const std::vector<std::string> callers = printed_kernels(unit, kernels, function_adds_functions, kernel_function);
    Writer checks, members, pipelines, tests, types;
    if (options_.tests && unit.home == module_) {
        unit.translation_checks = print_translation_checks(unit, checks);
        unit.block_lists = print_block_lists(unit, checks);
    }
    std::map<ir::StructureId, std::string> texts;  ///< of the members of each class that is defined here
    for (ir::StructureId structure : reach_.structures) {
        if (program_.structures[structure].module != unit.home) continue;
        if (!defined_.structures.contains(structure)) {
            const std::size_t before = members.text().size();
            print_class_members(unit, members, structure);
            texts[structure] = members.text().substr(before);
        }
        if (reach_.moved.contains(structure) && !defined_.moved.contains(structure))
            print_transfers(unit, members, structure);
    }
    for (ir::PipelineId pipeline : reach_.pipelines) {
        if (program_.pipelines[pipeline].module != unit.home || defined_.pipelines.contains(pipeline)) continue;
        const std::size_t before = pipelines.text().size();
        print_pipeline(unit, pipelines, pipeline);
        if (const auto owner = texts.find(program_.pipelines[pipeline].owner); owner != texts.end())
            owner->second += pipelines.text().substr(before);
    }
    if (options_.reload) print_declared_types(unit, types, texts);
    if (options_.tests && unit.home == module_) print_tests(unit, tests);

    out.line("namespace " + unit.globals.space + " {");
    out.raw("\n");
    out.line("using namespace glift::types;");
    out.gap();
    if (options_.reload) print_hash_of_functions(unit, out);
    if (!unit.globals.functions.empty() || !checks.text().empty()) {
        out.line("namespace {");
        out.raw("\n");
        out.parts({unit.globals.functions, checks.text()});
        out.line("}  // namespace");
        out.gap();
    }
    for (std::size_t i = 0; i < kernels.size(); ++i) {
        out.parts({callers[i]});
        if (reach_.pub_kernels.contains(kernels[i])) out.parts({short_kernel_function(unit, kernels[i])});
    }
    out.parts({members.text(), pipelines.text(), tests.text(), types.text()});
    out.line("}  // namespace " + unit.globals.space);
}

std::string ModulePrinter::source() {
    Unit& unit = unit_of(module_);
    Writer out;
    print_includes(out);
    print_definitions(unit, out);
    if (options_.tests) {
        out.gap();
        out.open("int main(int argc, char** argv)");
        out.line("return glift::run_tests(" + (!unit.tests.empty() ? unit.globals.space + "::" + unit.tests : "{}") +
                 ", argc, argv);");
        out.close();
    }
    return out.take();
}

std::string ModulePrinter::library_source() {
    std::set<ir::ModuleId> homes;
    for (ir::KernelId kernel : reach_.kernels)
        if (!defined_.kernels.contains(kernel)) homes.insert(program_.kernels[kernel].module);
    for (ir::StructureId structure : reach_.structures)
        if (!defined_.structures.contains(structure) ||
            (reach_.moved.contains(structure) && !defined_.moved.contains(structure)))
            homes.insert(program_.structures[structure].module);
    for (ir::PipelineId pipeline : reach_.pipelines)
        if (!defined_.pipelines.contains(pipeline)) homes.insert(program_.pipelines[pipeline].module);
    Writer out;
    print_includes(out);
    for (ir::ModuleId home : homes) {
        if (home == module_) continue;
        print_definitions(unit_of(home), out);
        out.gap();
    }
    return out.take();
}

/// Notes for later modules of the run what this one defines. A test program shares nothing with test programs of other
/// modules.
void ModulePrinter::note_definitions() {
    if (options_.tests) return;
    defined_.kernels.insert(reach_.kernels.begin(), reach_.kernels.end());
    defined_.pipelines.insert(reach_.pipelines.begin(), reach_.pipelines.end());
    defined_.structures.insert(reach_.structures.begin(), reach_.structures.end());
    defined_.moved.insert(reach_.moved.begin(), reach_.moved.end());
}

Module ModulePrinter::print() {
    Module result;
    std::string own = source(), library = library_source();
    result.files.push_back({".glift.hpp", header()});
    result.files.push_back({".glift.types.hpp", types_header()});
    result.files.push_back({".glift.internal.hpp", internal_header()});
    result.files.push_back({".glift.cpp", std::move(own)});
    result.files.push_back({".glift.library.cpp", std::move(library)});
    for (bool is_own : {true, false})
        std::ranges::move(
            kernel_sources(parts_, stem_, kernels_to_define(is_own), is_own ? "kernels" : "library.kernels"),
            std::back_inserter(result.files));
    result.tests = std::move(unit_of(module_).test_names);
    note_definitions();
    return result;
}

}  // namespace

Module module_of(const ir::Program& program, const ir::Lowered& lowered, const Sources& sources, ir::ModuleId module,
                 const KernelCodes& code, const Options& options, Defined& defined) {
    return ModulePrinter(program, lowered, sources, module, code, options, defined).print();
}

}  // namespace gliftc::cpp
