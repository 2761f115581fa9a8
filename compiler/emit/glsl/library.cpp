#include "emit/glsl/library.h"

#include "emit/glsl/printer.h"
#include "emit/glsl/signs.h"
#include "ir/walk.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <utility>

namespace gliftc::glsl {

using namespace ir;

namespace {

/// For each parameter of the pass whether the function, or one that it calls, uses it. Only these are declared.
std::vector<bool> used_parameters(const Program& program, const Pass& pass) {
    std::vector<bool> used(pass.parameters.size());
    auto visit = [&](ExprId id) {
        if (program.exprs[id].op == Op::parameter) used.at(program.exprs[id].slot) = true;
    };
    for_each_expression(program, pass.plain().body, visit);
    for (FunctionId id : pass.functions) for_each_expression(program, program.functions[id].body, visit);
    return used;
}

/// What all functions of the library share: the union of their memories (the same place and index: the same memory),
/// and of the parameters that are their state (the same name: the same parameter).
struct Interface {
    Pass all;
    Scopes names;
    std::map<std::string, std::string> declared_parameters;  ///< by the names that the functions have for them

    std::string binding(const PassBinding& wanted) {
        for (PassBinding& have : all.bindings)
            if (have.place == wanted.place && have.memory == wanted.memory) {
                if (have.access != wanted.access) have.access = Access::read_write;
                return have.name;
            }
        all.bindings.push_back(wanted);
        return all.bindings.back().name = names.declare(wanted.name);
    }

    std::string parameter(const PassParameter& wanted) {
        const auto [found, is_new] = declared_parameters.try_emplace(wanted.name);
        if (!is_new) return found->second;
        all.parameters.push_back(wanted);
        return found->second = all.parameters.back().name = names.declare(wanted.name);
    }
};

std::string upper_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

/// Copies from one printer to another the names that it has declared, and the types, helpers and extensions that it has
/// found to be needed.
void carry_over(const Printer& from, Printer& to) {
    to.names = from.names;
    to.struct_names = from.struct_names;
    to.field_names = from.field_names;
    to.function_names = from.function_names;
    to.extensions = from.extensions;
    to.struct_types = from.struct_types;
    to.helpers = from.helpers;
    to.enumerators = from.enumerators;
}

std::string print_function(Printer& p, const LibraryFunction& wanted, const std::string& name) {
    p.names.enter();
    std::string parameters;
    for (LocalId id : wanted.pass.params) {
        const Local& local = p.program.locals[id];
        if (is_empty(p.program, local.type)) continue;
        p.local_names[id] = p.names.declare((*p.program.names)[local.name]);
        parameters += (parameters.empty() ? "" : ", ") + declaration(p, local.type, p.local_names[id]);
    }
    line(p, type_text(p, wanted.result) + " " + name + "(" + parameters + ") {");
    p.indent = 1;
    find_choices(p, wanted.pass.params, p.pass.plain().body);
    for (StmtId id : p.pass.plain().body) {
        const Stmt& stmt = p.program.stmts[id];
        if (stmt.op == StmtOp::evaluate) line(p, "return " + print_any(p, stmt.value) + ";");
        else print_statement(p, id);
    }
    p.indent = 0;
    line(p, "}");
    p.names.leave();
    return std::exchange(p.out, {});
}

/// The memories, with macros for their bindings, which the including shader chooses.
std::string memories_text(Printer& p, const std::string& macro) {
    std::string text = bindings_text(p);
    replace_all(text, "set = 0, binding = ", "set = " + macro + "_SET, binding = " + macro + "_BINDING + ");
    return text;
}

std::string state_text(Printer& p, const std::string& name, const std::string& macro) {
    if (p.pass.parameters.empty()) return "";
    const std::string text = "layout(scalar, set = " + macro + "_SET, binding = " + macro +
                             "_BINDING) readonly buffer " + name + "_state {\n" + parameter_members(p) + "};\n";
    return "#ifndef " + macro + "_STATE  // define it if you declare the members below in a block yourself\n" + text +
           "#endif\n\n";
}

std::string heading(const Program& program, const Sources& sources, StructureId structure, const std::string& macro) {
    const Structure& s = program.structures[structure];
    std::string text = "// " + s.display;
    if (s.span) text += ", " + file_name(sources[s.span.file].path) + ":" + std::to_string(sources.line_of(s.span));
    return text + ".\n// Define " + macro +
           "_BINDING before including. The structure's state (the members declared below) is at that binding, memory k "
           "at " +
           macro + "_BINDING + 1 + k.\n// Optional: " + macro + "_SET (the descriptor set, else 0), " + macro +
           "_STATE (see below), " + macro + "_READONLY (nothing is written).\n";
}

/// `has_bindings`: there are memories, which are bound even if the shader declares the state in a block of its own.
std::string macros_text(const std::string& macro, bool has_bindings) {
    std::string text = "#ifndef " + macro + "_SET\n#define " + macro + "_SET 0\n#endif\n";
    const std::string missing = has_bindings ? "#ifndef " + macro + "_BINDING\n"
                                             : "#if !defined " + macro + "_BINDING && !defined " + macro + "_STATE\n";
    text += missing + "#error define " + macro + "_BINDING before this file is included\n#endif\n";
    return text + "#ifdef " + macro + "_READONLY\n#define " + macro + "_ACCESS readonly\n#else\n#define " + macro +
           "_ACCESS\n#endif\n\n";
}

/// The FNV-1a hash of the text, cut to 31 bits so that it is a number for GLSL's preprocessor.
std::string number_of(const std::string& text) {
    std::uint32_t hash = 2166136261u;
    for (char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return std::to_string(hash & 0x7fffffffu);
}

/// Text that several included files may contain, guarded so that a shader has it once. A shader that includes another
/// text under the same macro gets `error`.
std::string once(const std::string& macro, const std::string& text, const std::string& error) {
    const std::string number = number_of(text);
    return "#ifndef " + macro + "\n#define " + macro + " " + number + "\n" + text + "#elif " + macro + " != " + number +
           "\n#error " + error + "\n#endif\n";
}

std::string structs_text(Printer& p) {
    std::string text;
    for (TypeId type : p.struct_types) {
        const std::string name = type_text(p, type);
        text += once("GLIFT_STRUCT_" + name, struct_definition(p, type),
                     "another struct is called " + name + " in a file included before") +
                "\n";
    }
    return text;
}

std::string enumerators_once(const Printer& p) {
    std::string text;
    for (const auto& [key, name] : p.enumerators) {
        const std::string value = std::to_string(p.program.enums[key.first].values[key.second]);
        const std::string macro = "GLIFT_ENUMERATOR_" + name + "_" + value;
        text += "#ifndef " + macro + "\n#define " + macro + "\nconst uint " + name + " = " + value + "u;\n#endif\n";
    }
    return text.empty() ? "" : text + "\n";
}

std::string helpers_text(Printer& p) {
    std::string text;
    for (const std::string& helper : helper_list(p)) {
        const std::string macro = "GLIFT_HELPER_" + number_of(helper);
        text += "#ifndef " + macro + "\n#define " + macro + "\n" + helper + "#endif\n\n";
    }
    return text;
}

}  // namespace

std::string library_of(const Program& program, const Sources& sources, const Library& library) {
    const std::string name = identifier(library.name), macro = upper_case(name);
    Interface interface;
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> bindings, parameters;
    for (const char* ending : {"_SET", "_BINDING", "_STATE", "_READONLY", "_ACCESS"})
        interface.names.declare(macro + ending);
    interface.names.declare(name + "_state");
    std::map<std::string, std::string> declared;  // overloads have one name
    for (const LibraryFunction& function : library.functions) {
        const auto [found, is_new] = declared.try_emplace(function.name);
        if (is_new) found->second = interface.names.declare(name + "_" + function.name);
        names.push_back(found->second);
    }
    for (const LibraryFunction& function : library.functions) {
        std::vector<bool> used = used_parameters(program, function.pass);
        bindings.emplace_back();
        parameters.emplace_back();
        for (const PassBinding& binding : function.pass.bindings) bindings.back().push_back(interface.binding(binding));
        for (std::size_t i = 0; i < used.size(); ++i)
            parameters.back().push_back(used[i] ? interface.parameter(function.pass.parameters[i])
                                                : function.pass.parameters[i].name);
    }
    for (PassBinding& binding : interface.all.bindings) binding.access = Access::read_write;

    Printer all(program, sources, interface.all, {});
    all.names = interface.names;
    all.function_prefix = name + "_";
    for (const PassBinding& binding : interface.all.bindings) {
        all.binding_names.push_back(binding.name);
        all.block_names.push_back(all.names.declare(binding.name + "_memory"));
    }
    for (const PassParameter& parameter : interface.all.parameters) all.parameter_names.push_back(parameter.name);
    name_structs(all);
    std::string functions;
    for (std::size_t i = 0; i < library.functions.size(); ++i) {
        const LibraryFunction& function = library.functions[i];
        Printer p(program, sources, function.pass, {});
        carry_over(all, p);
        p.function_prefix = all.function_prefix;
        p.binding_names = bindings[i];
        p.parameter_names = parameters[i];
        std::string text = callees_text(p);  // before print_function: it names the callees
        text += print_function(p, function, names[i]);
        bool writes = program.types.kind(function.result) == TypeKind::void_;
        functions += writes ? "#ifndef " + macro + "_READONLY\n" + text + "#endif\n" : text + "\n";
        carry_over(p, all);
    }
    std::string memories = memories_text(all, macro);
    replace_all(memories, ") buffer ", ") " + macro + "_ACCESS buffer ");
    for (const std::string kind : {"image", "iimage", "uimage"})  // samplers have no access qualifier
        replace_all(memories, ") uniform " + kind, ") uniform " + macro + "_ACCESS " + kind);
    const std::string state = state_text(all, name, macro), helpers = helpers_text(all), structs = structs_text(all);
    const std::string macros = state.empty() && memories.empty() ? "" : macros_text(macro, !memories.empty());
    return heading(program, sources, library.structure, macro) +
           once("GLIFT_" + macro,
                extensions_text(all) + macros + enumerators_once(all) + structs + state + memories +
                    (memories.empty() ? "" : "\n") + helpers + functions,
                "the functions of another structure called " + library.name + " are included already");
}

}  // namespace gliftc::glsl
