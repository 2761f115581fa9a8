#include "emit/cpp/reloadable.h"

#include "ir/print.h"

namespace gliftc::cpp {

namespace {

/// FNV-1a of the text, as a C++ literal, without what an edit of lines before it changes: comments, and the lines that
/// profiles show (glift/mark.h).
std::string hash_of(std::string_view text) {
    std::uint64_t hash = 14695981039346656037u;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
        const std::string_view line = text.substr(0, length);
        text.remove_prefix(length);
        const std::size_t first = line.find_first_not_of(' ');
        if (first != line.npos && line.substr(first).starts_with("//")) continue;
        if (line.find("glift::PipelineMark _mark(") != line.npos) continue;
        for (char c : line) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    }
    return std::to_string(hash) + "u";
}

/// The names of the functions' objects begin with '_', as no name of the language does.
constexpr const char* functions_hash = "_functions";

std::string qualified(const Unit& unit, const std::string& name) { return quoted(unit.globals.space + "::" + name); }

void print_declared(Unit& unit, Writer& out, const std::string& name, const std::string& text) {
    out.line("const glift::ReloadableType _type_" + name + "(" + qualified(unit, name) + ", " + hash_of(text) + ");");
}

/// All that the program's memory, and the code that is not replaced, have of a structure.
std::string text_of(Unit& unit, ir::StructureId index, const std::string& members) {
    Writer text;
    print_class(unit, text, index);
    text.raw(members);
    for (const ir::Stage& stage : unit.program.structures[index].via)
        text.raw(ir::print(unit.program, unit.program.translators[stage.translator].translate));
    return text.take();
}

}  // namespace

void print_function(const Unit& unit, Writer& out, const FunctionParts& parts, const std::string& body) {
    if (!unit.options.reload) {
        out.open(parts.linkage + parts.head);
        out.raw(body);
        out.close();
        return;
    }
    const std::string code = "_code_" + parts.stem, newest = "_newest_" + parts.stem;
    std::string head = parts.head;
    head.replace(head.find(" " + parts.name + "(") + 1, parts.name.size(), code);
    out.line("namespace {");
    out.open(head);
    out.raw(body);
    out.close();
    out.line("const glift::ReloadableFunction " + newest + "(" + qualified(unit, parts.name) + ", " +
             quoted(parts.declared) + ", " + functions_hash + " ^ " + hash_of(body) + ", &" + code +
             (parts.kernel.empty() ? "" : ", &" + parts.kernel) + ");");
    out.line("}  // namespace");
    out.gap();
    out.open(parts.linkage + parts.head);
    out.line("return " + newest + ".newest(&" + code + ")(" + parts.arguments + ");");
    out.close();
}

void print_hash_of_functions(const Unit& unit, Writer& out) {
    out.line("namespace {");
    out.line(std::string("[[maybe_unused]] constexpr std::uint64_t ") + functions_hash + " = " +
             hash_of(unit.globals.functions) + ";");
    out.line("}  // namespace");
    out.gap();
}

void print_declared_types(Unit& unit, Writer& out, const std::map<ir::StructureId, std::string>& members) {
    Writer types;
    for (ir::StructId index : unit.reach.structs) {
        if (unit.program.structs[index].module != unit.home) continue;
        Writer text;
        print_struct(unit, text, index);
        print_declared(unit, types, unit.own.structs[index], text.text());
    }
    for (ir::EnumId index : unit.reach.enums) {
        if (unit.program.enums[index].module != unit.home) continue;
        Writer text;
        print_enum(unit, text, index);
        print_declared(unit, types, unit.own.enums[index], text.text());
    }
    for (const auto& [structure, text] : members)
        print_declared(unit, types, unit.own_name(structure), text_of(unit, structure, text));
    if (types.text().empty()) return;
    out.line("namespace {");
    out.raw(types.text());
    out.line("}  // namespace");
    out.gap();
}

}  // namespace gliftc::cpp
