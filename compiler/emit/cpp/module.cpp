// A module's headers and sources, put together from their parts.
//
//   <name>.glift.hpp           what a program sees: the module's own, and classes that it shows of others
//   <name>.glift.cpp           the module's own kernels, pipelines and members of classes
//   <name>.glift.internal.hpp  what both sources see: hidden classes and functions
//   <name>.glift.library.cpp   the same of other modules, where no other source has it
//
// A class is defined where it is not defined yet: by the #ifndef of its name. A function of a module that has a source
// of its own is defined there; other functions are weak, so that it does not matter how many sources define them.
#include "base/parallel.h"
#include "emit/cpp/unit.h"

#include <algorithm>
#include <map>

namespace gliftc::cpp {

namespace {

constexpr std::size_t kernels_of_a_thread = 16;  ///< to print fewer takes less time than a thread

/// The file's name without its folder and `.glift`.
std::string stem_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    std::string name = path.substr(slash == std::string::npos ? 0 : slash + 1);
    if (name.ends_with(".glift")) name.resize(name.size() - 6);
    return name;
}

/// Blocks of namespaces: one after the other, each as long as it goes on.
class Spaces {
public:
    explicit Spaces(Writer& out) : out_(out) {}
    void enter(const std::string& space) {
        if (open_ == space) return;
        leave();
        out_.gap();
        out_.line("namespace " + space + " {");
        out_.raw("\n");
        open_ = space;
    }
    void leave() {
        if (open_.empty()) return;
        out_.gap();
        out_.line("}  // namespace " + open_);
        open_.clear();
    }

private:
    Writer& out_;
    std::string open_;
};

/// With an empty line after each.
void append_parts(Writer& out, const std::vector<std::string_view>& parts) {
    std::size_t bytes = 0;
    for (std::string_view part : parts) bytes += part.size() + 1;
    out.reserve(bytes);
    for (std::string_view part : parts) {
        out.raw(part);
        out.gap();
    }
}

/// What `print` makes of each kernel. Those that add functions to the file come first and in order, which is that of
/// the functions; the others change nothing that they share.
std::vector<std::string> printed_kernels(Unit& unit, const std::vector<std::uint32_t>& kernels,
                                         bool (&adds_functions)(const Unit&, std::uint32_t),
                                         std::string (&print)(Unit&, std::uint32_t)) {
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

/// What the generated function of a kernel names besides its parameters.
void name_parameters(Unit& unit, const ir::Kernel& kernel) {
    Scopes names;
    names.avoid(unit.globals.type_names);
    names.avoid(unit.globals.kernel_symbols);
    names.reserve({"commands", "iteration", "memories", "parameters"});
    for (const ir::KernelParam& param : kernel.params)
        unit.globals.param_names[&param] = names.declare(unit.name(param.name));
}

/// Beside each kernel's function: its code, and the data that describes it.
void name_symbols(Unit& unit) {
    static constexpr auto suffixes = std::to_array<const char*>(
        {"_bindings", "_direct", "_direct_group", "_direct_parameters", "_direct_rows", "_direct_spirv", "_general",
         "_general_group", "_general_parameters", "_general_rows", "_general_spirv", "_kernel", "_other_files",
         "_parameters", "_wide", "_wide_group", "_wide_parameters", "_wide_rows", "_wide_spirv"});
    Globals& globals = unit.globals;
    for (std::uint32_t kernel : unit.reach.kernels) {
        if (unit.program.kernels[kernel].module != unit.home) continue;
        const std::string stem = globals.names.declare_stem(unit.own.kernels[kernel], suffixes);
        for (const char* suffix : suffixes) globals.kernel_symbols.insert(stem + suffix);
        globals.kernel_stems[kernel] = stem;
    }
}

/// All that is made for one module.
class ModulePrinter {
public:
    ModulePrinter(const ir::Program& program, const ir::Lowered& lowered, const Sources& sources, std::uint32_t module,
                  const std::vector<KernelCode>& code, const Options& options, Defined& defined);

    Module print();

private:
    Unit& unit_of(std::uint32_t home);
    bool has_source(std::uint32_t module) const;
    bool is_shown(std::uint32_t pipeline) const;
    bool is_declared_elsewhere(bool is_pub, const std::string& key, std::uint32_t module) const;
    void find_shown_elsewhere();

    template <class Print>
    void print_once(Writer& out, Spaces& spaces, std::uint32_t home, const std::string& name, const Print& print);
    void print_types(Writer& out, Spaces& spaces);
    void print_classes(Writer& out, Spaces& spaces, bool (ModulePrinter::*wanted)(std::uint32_t) const);
    void print_aliases(Writer& out, Spaces& spaces, std::uint32_t structure);
    bool is_in_header(std::uint32_t structure) const { return reach_.in_header.contains(structure); }
    bool is_hidden(std::uint32_t structure) const { return !is_in_header(structure); }
    void print_functions_shown(Writer& out);
    void print_functions_hidden(Writer& out, Spaces& spaces);
    void print_definitions(Unit& unit, Writer& out);
    void note_definitions();

    std::string begin_of_file() const {
        return "// Made by gliftc from " + stem_ + ".glift. Changes are lost when it is made again.";
    }
    std::string header();
    std::string internal_header();
    std::string source();
    std::string library_source();
    void print_includes(Writer& out) const;
    bool has_reports() const;

    const ir::Program& program_;
    const ir::Lowered& lowered_;
    const Sources& sources_;
    std::uint32_t module_;
    const std::vector<KernelCode>& code_;
    const Options& options_;
    Defined& defined_;
    const ProgramNames names_;
    Reach reach_;
    Reach elsewhere_;  ///< what headers show that this module's header includes
    std::map<std::uint32_t, Unit> units_;
    std::string stem_;
};

ModulePrinter::ModulePrinter(const ir::Program& program, const ir::Lowered& lowered, const Sources& sources,
                             std::uint32_t module, const std::vector<KernelCode>& code, const Options& options,
                             Defined& defined)
    : program_(program), lowered_(lowered), sources_(sources), module_(module), code_(code), options_(options),
      defined_(defined), names_(program_names(program)), reach_(reach_of(program, module, options)),
      stem_(stem_of(sources[program.modules[module].file].path)) {
    add_inner_structs(reach_, program, lowered);
    find_shown_elsewhere();
}

/// A source of its own is made for the module in this run. A test program is one source.
bool ModulePrinter::has_source(std::uint32_t module) const {
    return module == module_ || (program_.modules[module].is_root && !options_.tests);
}

void ModulePrinter::find_shown_elsewhere() {
    for (std::uint32_t import : program_.modules[module_].imports) {
        if (import == module_ || !has_source(import)) continue;
        const Reach shown = reach_of(program_, import, options_);
        elsewhere_.in_header.insert(shown.in_header.begin(), shown.in_header.end());
        elsewhere_.enums.insert(shown.enums.begin(), shown.enums.end());
        elsewhere_.structs.insert(elsewhere_.structs.end(), shown.structs.begin(), shown.structs.end());
    }
}

Unit& ModulePrinter::unit_of(std::uint32_t home) {
    if (const auto found = units_.find(home); found != units_.end()) return found->second;
    Unit unit{program_, lowered_, sources_, module_, home,
              code_,    options_, reach_,   names_,  make_globals(program_, sources_, names_, {module_, home}),
              {}};
    name_symbols(unit);
    for (std::uint32_t kernel : reach_.kernels)
        if (program_.kernels[kernel].module == home) name_parameters(unit, program_.kernels[kernel]);
    return units_.emplace(home, std::move(unit)).first->second;
}

bool ModulePrinter::is_shown(std::uint32_t pipeline) const {
    const ir::Pipeline& p = program_.pipelines[pipeline];
    return p.is_pub && p.module == module_ && !p.owner && !options_.tests;
}

/// By a header that this module's header includes.
bool ModulePrinter::is_declared_elsewhere(bool is_pub, const std::string& key, std::uint32_t module) const {
    return is_pub && module != module_ && has_source(module) && key.find('<') == std::string::npos;
}

template <class Print> void ModulePrinter::print_once(Writer& out, Spaces& spaces, std::uint32_t home,
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
    for (std::uint32_t index : reach_.enums) {
        const ir::Enum& type = program_.enums[index];
        if (elsewhere_.enums.contains(index)) continue;
        print_once(out, spaces, type.module, names_.enums[index],
                   [&](Unit& unit, Writer& text) { print_enum(unit, text, index); });
    }
    for (std::uint32_t index : reach_.structs) {
        const ir::Struct& type = program_.structs[index];
        if (std::ranges::find(elsewhere_.structs, index) != elsewhere_.structs.end()) continue;
        print_once(out, spaces, type.module, names_.structs[index],
                   [&](Unit& unit, Writer& text) { print_struct(unit, text, index); });
    }
}

/// The names by which the module knows a structure. Those of modules that have a header are there.
void ModulePrinter::print_aliases(Writer& out, Spaces& spaces, std::uint32_t index) {
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

void ModulePrinter::print_classes(Writer& out, Spaces& spaces, bool (ModulePrinter::*wanted)(std::uint32_t) const) {
    for (std::uint32_t index : reach_.structures) {
        if (!(this->*wanted)(index)) continue;
        const ir::Structure& structure = program_.structures[index];
        if (!elsewhere_.in_header.contains(index))
            print_once(out, spaces, structure.module, names_.structures[index],
                       [&](Unit& unit, Writer& text) { print_class(unit, text, index); });
        print_aliases(out, spaces, index);
    }
}

void ModulePrinter::print_functions_shown(Writer& out) {
    Unit& unit = unit_of(module_);
    for (std::uint32_t kernel : reach_.kernels) {
        if (!reach_.pub_kernels.contains(kernel)) continue;
        write_doc(out, program_.kernels[kernel].doc);
        out.line(kernel_signature(unit, kernel, true) + ";");
        if (range_of_first_at(program_.kernels[kernel])) out.line(kernel_signature(unit, kernel, true, 1) + ";");
        out.gap();
    }
    for (std::uint32_t pipeline : reach_.pipelines) {
        if (!is_shown(pipeline)) continue;
        write_doc(out, program_.pipelines[pipeline].doc);
        out.line(pipeline_signature(unit, pipeline, true) + ";");
        out.gap();
    }
}

void ModulePrinter::print_functions_hidden(Writer& out, Spaces& spaces) {
    for (std::uint32_t index : reach_.kernels) {
        const ir::Kernel& kernel = program_.kernels[index];
        if (reach_.pub_kernels.contains(index) || is_declared_elsewhere(kernel.is_pub, kernel.key, kernel.module))
            continue;
        Unit& unit = unit_of(kernel.module);
        spaces.enter(unit.globals.space);
        out.line(kernel_signature(unit, index, true) + ";");
    }
    for (std::uint32_t index : reach_.pipelines) {
        const ir::Pipeline& pipeline = program_.pipelines[index];
        if (pipeline.owner || is_shown(index) || is_declared_elsewhere(pipeline.is_pub, pipeline.key, pipeline.module))
            continue;
        Unit& unit = unit_of(pipeline.module);
        spaces.enter(unit.globals.space);
        out.line(pipeline_signature(unit, index, true) + ";");
    }
}

std::string ModulePrinter::header() {
    Writer out;
    out.line(begin_of_file());
    out.line("#pragma once");
    out.gap();
    std::set<std::string> headers;
    for (std::uint32_t import : program_.modules[module_].imports)
        if (import != module_ && has_source(import))
            headers.insert(stem_of(sources_[program_.modules[import].file].path) + ".glift.hpp");
    for (std::uint32_t index : reach_.structs)
        if (const std::string& header = program_.structs[index].extern_header; !header.empty()) headers.insert(header);
    for (const std::string& header : headers) out.line("#include \"" + header + "\"");
    out.gap();
    out.line("#include <glift/glift.h>");
    out.line("#include <glift/structure.h>");
    out.gap();
    out.line("#include <cstddef>");
    out.gap();
    write_doc(out, program_.modules[module_].doc);
    Spaces spaces(out);
    print_types(out, spaces);
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

std::string ModulePrinter::internal_header() {
    Writer out;
    out.line(begin_of_file());
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

bool ModulePrinter::has_reports() const {
    return std::ranges::any_of(reach_.kernels,
                               [&](std::uint32_t kernel) { return lowered_.passes[kernel].general.has_reports; });
}

void ModulePrinter::print_includes(Writer& out) const {
    out.line(begin_of_file());
    out.line("#include \"" + stem_ + ".glift.internal.hpp\"");
    out.gap();
    out.line("#include <glift/host/image.h>");
    out.line("#include <glift/host/math.h>");
    out.line("#include <glift/host/parallel.h>");
    if (has_reports()) out.line("#include <glift/host/report.h>");
    out.gap();
    out.line("#include <optional>");
    out.gap();
}

/// What of the namespace is defined here.
void ModulePrinter::print_definitions(Unit& unit, Writer& out) {
    std::vector<std::uint32_t> kernels;
    for (std::uint32_t kernel : reach_.kernels)
        if (program_.kernels[kernel].module == unit.home && !defined_.kernels.contains(kernel))
            kernels.push_back(kernel);
    const std::vector<std::string> codes = printed_kernels(unit, kernels, code_adds_functions, kernel_code);
    const std::vector<std::string> callers = printed_kernels(unit, kernels, function_adds_functions, kernel_function);
    Writer checks, members, pipelines;
    if (options_.tests && unit.home == module_) unit.translation_checks = print_translation_checks(unit, checks);
    for (std::uint32_t structure : reach_.structures)
        if (program_.structures[structure].module == unit.home && !defined_.structures.contains(structure))
            print_class_members(unit, members, structure);
    for (std::uint32_t pipeline : reach_.pipelines)
        if (program_.pipelines[pipeline].module == unit.home && !defined_.pipelines.contains(pipeline))
            print_pipeline(unit, pipelines, pipeline);
    Writer tests;
    if (options_.tests && unit.home == module_) print_tests(unit, tests);

    // Nearly all of the text: without room for it, the last parts would move the others.
    std::size_t bytes = members.text().size() + pipelines.text().size();
    for (const std::string& code : codes) bytes += code.size() + 1;
    out.reserve(bytes + bytes / 16);
    out.line("namespace " + unit.globals.space + " {");
    out.raw("\n");
    out.line("using namespace glift::types;");
    out.gap();
    if (!unit.globals.functions.empty() || !codes.empty() || !checks.text().empty()) {
        out.line("namespace {");
        out.raw("\n");
        append_parts(out, {unit.globals.functions});
        append_parts(out, {codes.begin(), codes.end()});
        append_parts(out, {checks.text()});
        out.line("}  // namespace");
        out.gap();
    }
    for (std::size_t i = 0; i < kernels.size(); ++i) {
        append_parts(out, {callers[i]});
        if (reach_.pub_kernels.contains(kernels[i])) append_parts(out, {short_kernel_function(unit, kernels[i])});
    }
    append_parts(out, {members.text(), pipelines.text(), tests.text()});
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
    std::set<std::uint32_t> homes;
    for (std::uint32_t kernel : reach_.kernels)
        if (!defined_.kernels.contains(kernel)) homes.insert(program_.kernels[kernel].module);
    for (std::uint32_t structure : reach_.structures)
        if (!defined_.structures.contains(structure)) homes.insert(program_.structures[structure].module);
    for (std::uint32_t pipeline : reach_.pipelines)
        if (!defined_.pipelines.contains(pipeline)) homes.insert(program_.pipelines[pipeline].module);
    Writer out;
    print_includes(out);
    for (std::uint32_t home : homes) {
        if (home == module_) continue;
        print_definitions(unit_of(home), out);
        out.gap();
    }
    return out.take();
}

/// A test program is one: it shares nothing with those of other modules.
void ModulePrinter::note_definitions() {
    if (options_.tests) return;
    defined_.kernels.insert(reach_.kernels.begin(), reach_.kernels.end());
    defined_.pipelines.insert(reach_.pipelines.begin(), reach_.pipelines.end());
    defined_.structures.insert(reach_.structures.begin(), reach_.structures.end());
}

Module ModulePrinter::print() {
    Module result;
    result.source = source();
    result.library = library_source();
    result.header = header();
    result.internal = internal_header();
    result.tests = std::move(unit_of(module_).test_names);
    note_definitions();
    return result;
}

}  // namespace

const char* Unit::linkage(const std::string& key) const {
    return home == module && key.find('<') == std::string::npos ? "" : "GLIFT_SHARED ";
}

std::uint32_t structure_at(const ir::Program& program, std::uint32_t structure, const ir::Place& place) {
    for (std::uint32_t member : place.members) structure = program.structures[structure].members[member].structure;
    return structure;
}

Module module_of(const ir::Program& program, const ir::Lowered& lowered, const Sources& sources, std::uint32_t module,
                 const std::vector<KernelCode>& code, const Options& options, Defined& defined) {
    return ModulePrinter(program, lowered, sources, module, code, options, defined).print();
}

}  // namespace gliftc::cpp
