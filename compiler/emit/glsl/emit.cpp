// A whole shader: of a kernel, or of a part of a draw.
#include "emit/glsl/emit.h"

#include "emit/glsl/printer.h"
#include "emit/glsl/quick_quotients.h"
#include "emit/glsl/signs.h"
#include "ir/walk.h"
#include "layout/layout.h"

#include <algorithm>
#include <cctype>

namespace gliftc::glsl {

namespace {

std::string capitalised(std::string name) {
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
}

/// Workgroup arrays that share an allocation (layout/workgroup.h) are one variable, whose name joins theirs: `a_or_b`.
void name_shared(Printer& p) {
    for (const std::vector<ir::LocalId>& place : p.pass.shared_places) {
        std::vector<std::string> names;
        for (ir::LocalId id : place) {
            const std::string& name = (*p.program.names)[p.program.locals[id].name];
            if (std::ranges::find(names, name) == names.end()) names.push_back(name);
        }
        std::string joined = names.front();
        for (std::size_t i = 1; i < names.size(); ++i) joined += "_or_" + names[i];
        joined = p.names.declare(joined);
        for (ir::LocalId id : place) p.local_names[id] = joined;
    }
}

/// Names everything that the shader declares outside functions, except functions and helpers, and what bodies turn out
/// to need (Scopes::declare_outermost). This comes first, so that no local gets one of these names.
void name_globals(Printer& p) {
    for (const ir::PassParameter& parameter : p.pass.parameters)
        p.parameter_names.push_back(parameter.source == ir::ParameterSource::address ? ""
                                                                                     : p.names.declare(parameter.name));
    for (const ir::PassBinding& binding : p.pass.bindings) p.binding_names.push_back(p.names.declare(binding.name));
    for (const std::string& name : p.binding_names) p.block_names.push_back(p.names.declare(capitalised(name)));
    for (const ir::PassBinding& binding : p.pass.bindings) {
        p.row_names.push_back(binding.in_rows ? p.names.declare(binding.name + "_rows") : "");
        p.row_block_names.push_back(binding.in_rows ? p.names.declare(capitalised(binding.name + "_rows")) : "");
    }
    for (std::size_t i = 0; i < p.pass.parameters.size(); ++i) {
        const ir::PassParameter& parameter = p.pass.parameters[i];
        if (parameter.source != ir::ParameterSource::address) continue;
        p.parameter_names[i] = p.binding_names.at(parameter.param);
        p.binding_names[parameter.param] = "parameters." + p.parameter_names[i];
    }
    p.member_names = p.parameter_names;
    if (!p.pass.push_constants) name_parameter_reads(p);
    name_structs(p);
    name_status(p);
    name_messages(p);
    name_order(p);
    name_shared(p);
    if (p.raster()) name_interface(p);
}

std::string take(Printer& p) {
    std::string text = std::move(p.out);
    p.out.clear();
    return text;
}

std::string function_text(Printer& p, ir::FunctionId id) {
    const ir::Function& function = p.program.functions[id];
    p.names.enter();
    std::string parameters;
    for (ir::LocalId param : function.params) {
        const ir::Local& local = p.program.locals[param];
        if (is_empty(p.program, local.type)) continue;
        p.local_names[param] = p.names.declare((*p.program.names)[local.name]);
        parameters += (parameters.empty() ? "" : ", ") + declaration(p, local.type, p.local_names[param]);
    }
    if (p.options.lines == LineMarks::comments && !function.display.empty() &&
        function.display != (*p.program.names)[function.name])
        line(p, "// " + function.display);
    mark_line(p, function.span);
    line(p, type_text(p, function.result) + " " + p.function_names.at(id) + "(" + parameters + ") {");
    p.indent = 1;
    find_choices(p, function.params, function.body);
    print_body(p, function.body);
    p.indent = 0;
    line(p, "}");
    p.names.leave();
    p.last_line = {};
    return take(p) + "\n";
}

/// Prints the prologue. In kernels without a group, invocations beyond the range return, unless they are needed for the
/// barriers of a body that itself tests which elements are in the range.
void print_prologue(Printer& p) {
    const bool is_grouped = p.program.kernels[p.pass.kernel].grouped();
    for (ir::StmtId id : p.pass.prologue) {
        const ir::Stmt& stmt = p.program.stmts[id];
        bool is_range_test =
            stmt.op == ir::StmtOp::let && p.pass.in_range && stmt.local == p.pass.in_range && stmt.value;
        if (is_grouped || !is_range_test) {
            print_statement(p, id);
            continue;
        }
        if (ir::has_any_barrier(p.program, p.body())) continue;
        line(p, "if (" + print_negated(p, stmt.value) + ") return;");
        p.in_range_is_known = true;
    }
}

const char* elements_text(const ir::Pass& pass) {
    if (!pass.updates.empty())
        return "// Each invocation takes several elements, and combines their updates before it makes them.";
    if (pass.of_blocks) return "// Each invocation takes several elements of a block, a workgroup's width apart.";
    if (!pass.tiles.empty())
        return "// Each invocation takes four elements of a tile, whose memory it accesses with two axes exchanged.";
    const auto& elements = variant_for(pass, ir::Devices::shaders).assumes.elements;
    if (elements[1] > 2)
        return "// Each invocation takes four elements: its own, and those in the next three rows if there are such.";
    if (pass.rank == 1)
        return "// Each invocation takes two elements: its own, and the one a workgroup's width further on if there is "
               "one.";
    return "// Each invocation takes two elements: its own, and the one in the next row if there is one.";
}

std::string main_text(Printer& p) {
    line(p, "void main() {");
    p.names.enter();
    p.indent = 1;
    print_round_start(p);
    print_parameter_copies(p);
    print_prologue(p);
    if (p.raster()) print_part_start(p);
    const ir::Variant& variant = variant_for(p.pass, ir::Devices::shaders);
    const bool is_coarsened = variant.assumes.elements != p.pass.plain().assumes.elements;
    if (is_coarsened && p.options.lines == LineMarks::comments) line(p, elements_text(p.pass));
    find_choices(p, {}, p.body());
    print_main_body(p, p.body());
    p.indent = 0;
    p.names.leave();
    line(p, "}");
    return take(p);
}

std::string shared_text(Printer& p) {
    std::string text;
    for (const std::vector<ir::LocalId>& place : p.pass.shared_places) {
        const ir::LocalId largest = *std::ranges::max_element(
            place, {}, [&](ir::LocalId id) { return layout::size_of(p.program, p.program.locals[id].type).size; });
        text += "shared " + declaration(p, p.program.locals[largest].type, p.local_names[largest]) + ";\n";
    }
    return text.empty() ? "" : text + "\n";
}

std::string group_text(const ir::Pass& pass) {
    std::string text = "layout(local_size_x = " + std::to_string(pass.group[0]);
    if (pass.group[1] > 1 || pass.group[2] > 1) text += ", local_size_y = " + std::to_string(pass.group[1]);
    if (pass.group[2] > 1) text += ", local_size_z = " + std::to_string(pass.group[2]);
    return text + ") in;\n\n";
}

const char* form_text(ir::Form form) {
    switch (form) {
    case ir::Form::direct: return "direct form: whole structures, of equal sizes where declared with one type";
    case ir::Form::general: return "general form: ranges may be parts of structures; buffers by address";
    }
    return "";
}

std::string heading(Printer& p) {
    const ir::Kernel& kernel = p.program.kernels[p.pass.kernel];
    std::string name = kernel.display.empty() ? (*p.program.names)[kernel.name] : kernel.display, where;
    if (kernel.span)
        where =
            ", " + file_name(p.sources[kernel.span.file].path) + ":" + std::to_string(p.sources.line_of(kernel.span));
    if (kernel.raster) name += p.options.part == ir::Part::vertex ? ", vertex part" : ", fragment part";
    return "// " + name + where + ": " + form_text(p.pass.form) + ".\n";
}

}  // namespace

void name_structs(Printer& p) {
    for (const ir::Struct& s : p.program.structs) {
        p.struct_names.push_back(p.names.declare(s.display.empty() ? (*p.program.names)[s.name] : s.display));
        Scopes fields;
        std::vector<std::string> names;
        for (const ir::StructField& field : s.fields) names.push_back(fields.declare((*p.program.names)[field.name]));
        p.field_names.push_back(std::move(names));
    }
}

void name_functions(Printer& p) {
    for (ir::FunctionId id : p.pass.functions) {
        const ir::Function& function = p.program.functions[id];
        const std::string name = p.function_prefix + (*p.program.names)[function.name];
        p.function_names[id] = p.names.declare(
            p.names.is_free(name) || function.display.empty() ? name : p.function_prefix + function.display);
    }
}

std::string callees_text(Printer& p) {
    name_functions(p);
    std::string text;
    for (ir::FunctionId id : p.pass.functions)
        if (!is_empty(p.program, p.program.functions[id].result)) text += function_text(p, id);
    return text;
}

std::string enumerators_text(const Printer& p) {
    std::string text;
    for (const auto& [key, name] : p.enumerators)
        text += "const uint " + name + " = " + std::to_string(p.program.enums[key.first].values[key.second]) + "u;\n";
    return text.empty() ? "" : text + "\n";
}

std::string extensions_text(Printer& p) {
    p.extensions.insert("GL_EXT_scalar_block_layout");
    if (p.pass.form == ir::Form::general) {
        p.extensions.insert("GL_EXT_buffer_reference");
        p.extensions.insert("GL_EXT_shader_explicit_arithmetic_types_int64");
    }
    if (p.options.lines == LineMarks::directives) p.extensions.insert("GL_GOOGLE_cpp_style_line_directive");
    std::string text;
    for (const std::string& extension : p.extensions) text += "#extension " + extension + " : require\n";
    return text + "\n";
}

std::string glsl_of(const ir::Program& program, const Sources& sources, const ir::Pass& pass, const Options& options) {
    Printer p(program, sources, pass, options);
    name_globals(p);
    // Bodies come first: they find out which types, helpers and extensions are needed.
    std::string functions = callees_text(p);
    std::string main = main_text(p), shared = shared_text(p), bindings = bindings_text(p),
                parameters = parameters_text(p);
    std::string status = status_definitions(p), atomics = atomic_definitions(p), helpers = helper_definitions(p),
                structs = struct_definitions(p);
    if (!bindings.empty()) bindings += "\n";
    if (!parameters.empty()) parameters += "\n";
    std::string interface = parameters + bindings;
    const std::string first = p.raster() ? interface_text(p) : group_text(pass);
    return "#version 460\n" + heading(p) + extensions_text(p) + first + enumerators_text(p) + structs + interface +
           shared + status + message_definitions(p) + order_definitions(p) + helpers + atomics + functions + main;
}

}  // namespace gliftc::glsl
