// A module's header and source, put together from their parts.
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

bool is_public(const Unit& unit, std::uint32_t kernel) { return unit.reach.pub_kernels.contains(kernel); }

bool is_shown(const Unit& unit, std::uint32_t pipeline) {
    const ir::Pipeline& p = unit.program.pipelines[pipeline];
    return p.is_pub && p.module == unit.module && !p.owner && !unit.options.tests;
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
         "_parameters", "_wide_spirv"});
    Globals& globals = unit.globals;
    for (std::uint32_t kernel : unit.reach.kernels) {
        const std::string stem = globals.names.declare_stem(globals.kernel_names.at(kernel), suffixes);
        for (const char* suffix : suffixes) globals.kernel_symbols.insert(stem + suffix);
        globals.kernel_stems[kernel] = stem;
    }
}

void name_functions(Unit& unit) {
    // Several pipelines may share a name and differ in the structures that they take: overloads.
    std::set<std::string> taken;
    for (std::uint32_t kernel : unit.reach.kernels) {
        if (is_public(unit, kernel))
            unit.globals.kernel_names[kernel] =
                unit.globals.names.declare(unit.name(unit.program.kernels[kernel].name));
    }
    std::map<std::uint32_t, std::string> overloads;
    for (std::uint32_t pipeline : unit.reach.pipelines) {
        const ir::Pipeline& p = unit.program.pipelines[pipeline];
        if (p.owner) continue;
        // Instances of generics may differ in nothing that C++ sees.
        const bool is_instance = p.name && p.display != unit.name(p.name);
        if (is_instance) {
            unit.globals.pipeline_names[pipeline] = unit.globals.names.declare(unit.name(p.name));
            continue;
        }
        std::string& name = overloads[p.name.index];
        if (name.empty())
            name = p.name ? unit.globals.names.declare(unit.name(p.name)) : unit.globals.names.declare("test");
        unit.globals.pipeline_names[pipeline] = p.name ? name : unit.globals.names.declare("test");
    }
    for (std::uint32_t kernel : unit.reach.kernels) {
        if (!is_public(unit, kernel))
            unit.globals.kernel_names[kernel] =
                unit.globals.names.declare(unit.name(unit.program.kernels[kernel].name));
    }
    for (std::uint32_t structure : unit.reach.structures) {
        const std::vector<std::uint32_t>& pipelines = unit.program.structures[structure].pipelines;
        for (std::size_t i = 0; i < pipelines.size(); ++i)
            unit.globals.pipeline_names[pipelines[i]] = unit.globals.class_names[structure].pipelines[i];
    }
    name_symbols(unit);
    for (std::uint32_t kernel : unit.reach.kernels) name_parameters(unit, unit.program.kernels[kernel]);
}

std::string header_of(Unit& unit, const std::string& stem) {
    Writer out;
    out.line("// Made by gliftc from " + stem + ".glift. Changes are lost when it is made again.");
    out.line("#pragma once");
    out.gap();
    out.line("#include <glift/glift.h>");
    out.line("#include <glift/structure.h>");
    out.gap();
    out.line("#include <cstddef>");
    std::set<std::string> headers;
    for (std::uint32_t index : unit.reach.structs) {
        const std::string& header = unit.program.structs[index].extern_header;
        if (!header.empty()) headers.insert(header);
    }
    for (const std::string& header : headers) out.line("#include \"" + header + "\"");
    out.gap();
    write_doc(out, unit.program.modules[unit.module].doc);
    out.line("namespace " + unit.globals.space + " {");
    out.raw("\n");
    print_structs(unit, out);
    for (std::uint32_t structure : unit.reach.structures) {
        if (!unit.reach.in_header.contains(structure)) continue;
        print_class(unit, out, structure, true);
        for (const std::string& name : unit.globals.other_names[structure])
            out.line("using " + name + " = " + unit.class_name(structure) + ";");
        if (!unit.globals.other_names[structure].empty()) out.gap();
    }
    for (std::uint32_t kernel : unit.reach.kernels) {
        if (!is_public(unit, kernel)) continue;
        write_doc(out, unit.program.kernels[kernel].doc);
        out.line(kernel_signature(unit, kernel, true) + ";");
        if (range_of_first_at(unit.program.kernels[kernel])) out.line(kernel_signature(unit, kernel, true, 1) + ";");
        out.gap();
    }
    for (std::uint32_t pipeline : unit.reach.pipelines) {
        if (!is_shown(unit, pipeline)) continue;
        write_doc(out, unit.program.pipelines[pipeline].doc);
        out.line(pipeline_signature(unit, pipeline, true, false) + ";");
        out.gap();
    }
    out.line("}  // namespace " + unit.globals.space);
    return out.take();
}

bool has_reports(const Unit& unit) {
    for (std::uint32_t kernel : unit.reach.kernels) {
        if (unit.lowered.passes[kernel].general.has_reports) return true;
    }
    return false;
}

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

std::string source_of(Unit& unit, const std::string& stem) {
    Writer types, functions, members, pipelines;
    for (std::uint32_t structure : unit.reach.structures) {
        if (!unit.reach.in_header.contains(structure)) print_class(unit, types, structure, false);
    }
    const std::vector<std::uint32_t> kernels(unit.reach.kernels.begin(), unit.reach.kernels.end());
    const std::vector<std::string> codes = printed_kernels(unit, kernels, code_adds_functions, kernel_code);
    const std::vector<std::string> callers = printed_kernels(unit, kernels, function_adds_functions, kernel_function);
    Writer hidden_functions, hidden_members;
    for (std::size_t i = 0; i < kernels.size(); ++i) {
        if (is_public(unit, kernels[i])) append_parts(functions, {callers[i], short_kernel_function(unit, kernels[i])});
        else append_parts(hidden_functions, {callers[i]});
    }
    for (std::uint32_t structure : unit.reach.structures)
        print_class_members(unit, unit.reach.in_header.contains(structure) ? members : hidden_members, structure);
    Writer checks;
    if (unit.options.tests) unit.translation_checks = print_translation_checks(unit, checks);
    std::string declarations;
    Writer hidden_pipelines;
    for (std::uint32_t pipeline : unit.reach.pipelines) {
        const bool hidden = !is_shown(unit, pipeline) && !unit.program.pipelines[pipeline].owner;
        const std::optional<std::uint32_t> owner = unit.program.pipelines[pipeline].owner;
        const bool private_owner = owner && !unit.reach.in_header.contains(*owner);
        if (hidden) declarations += pipeline_signature(unit, pipeline, false, false) + ";\n";
        print_pipeline(unit, hidden || private_owner ? hidden_pipelines : pipelines, pipeline);
    }

    Writer tests;
    if (unit.options.tests) print_tests(unit, tests);

    Writer out;
    out.line("// Made by gliftc from " + stem + ".glift. Changes are lost when it is made again.");
    out.line("#include \"" + stem + ".glift.hpp\"");
    out.gap();
    out.line("#include <glift/host/image.h>");
    out.line("#include <glift/host/math.h>");
    out.line("#include <glift/host/parallel.h>");
    if (has_reports(unit)) out.line("#include <glift/host/report.h>");
    if (unit.options.tests) out.line("#include <glift/translation_checks.h>");
    out.gap();
    out.line("#include <optional>");
    out.gap();
    out.line("namespace " + unit.globals.space + " {");
    out.raw("\n");
    out.line("using namespace glift::types;");
    out.gap();
    out.line("namespace {");
    out.raw("\n");
    // Nearly all of the text: without room for it, the last parts would move the others.
    std::size_t bytes = functions.text().size() + hidden_functions.text().size() + members.text().size();
    for (const std::string& code : codes) bytes += code.size() + 1;
    out.reserve(bytes + bytes / 16);
    append_parts(out, {types.text(), unit.globals.functions});
    append_parts(out, {codes.begin(), codes.end()});
    append_parts(out,
                 {hidden_functions.text(), declarations, checks.text(), hidden_members.text(), hidden_pipelines.text()});
    out.line("}  // namespace");
    out.gap();
    append_parts(out, {functions.text(), members.text(), pipelines.text()});
    const std::string table = tests.take();
    out.raw(table);
    out.line("}  // namespace " + unit.globals.space);
    if (unit.options.tests) {
        out.gap();
        out.open("int main(int argc, char** argv)");
        out.line("return glift::run_tests(" + (table.empty() ? "{}" : unit.globals.space + "::" + unit.tests) + ", argc, argv);");
        out.close();
    }
    return out.take();
}

}  // namespace

std::uint32_t structure_at(const ir::Program& program, std::uint32_t structure, const ir::Place& place) {
    for (std::uint32_t member : place.members) structure = program.structures[structure].members[member].structure;
    return structure;
}

Module module_of(const ir::Program& program, const ir::Lowered& lowered, const Sources& sources, std::uint32_t module,
                 const std::vector<KernelCode>& code, const Options& options) {
    Unit unit{program,
              lowered,
              sources,
              module,
              code,
              options,
              reach_of(program, module, options),
              make_globals(program, sources, module)};
    add_inner_structs(unit.reach, program, lowered);
    name_functions(unit);
    const std::string stem = stem_of(sources[program.modules[module].file].path);
    Module result;
    result.source = source_of(unit, stem);
    result.header = header_of(unit, stem);
    result.tests = std::move(unit.test_names);
    return result;
}

}  // namespace gliftc::cpp
