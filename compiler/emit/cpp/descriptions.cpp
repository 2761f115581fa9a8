// The function `describe` of generated classes and structs, which names their parts to programs that inspect structures
// of any type.
#include "emit/cpp/unit.h"

namespace gliftc::cpp {

void print_description(const Unit& unit, Writer& out, ir::StructureId index) {
    const ir::Structure& structure = unit.program.structures[index];
    const ClassNames& names = unit.globals.class_names[index];
    const auto part = [&](const char* what, Name name, const std::string& value) {
        out.line(std::string("see.") + what + "(" + quoted(unit.name(name)) + ", " + value + ");");
    };
    out.gap();
    out.open("template <class See> void describe(See&& see) const");
    for (std::size_t i = 0; i < structure.constructor.size(); ++i)
        part("value", unit.program.locals[structure.constructor[i]].name, names.argument_fields[i]);
    for (std::size_t i = 0; i < structure.host.size(); ++i) part("value", structure.host[i].name, names.host[i] + "()");
    for (const ir::Method& method : structure.methods) {
        if (!unit.program.functions[method.function].params.empty()) continue;
        const std::string& called = names.methods[static_cast<std::size_t>(&method - structure.methods.data())];
        part("value", unit.program.functions[method.function].name, called + (method.pipeline ? "(device())" : "()"));
    }
    for (std::size_t i = 0; i < structure.memories.size(); ++i)
        part("memory", structure.memories[i].name, names.memories[i] + "()");
    if (structure.base.size() > 1) part("memory", structure.base_name, names.base + "()");
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        if (structure.members[i].is_component) continue;
        const bool is_memory = structure.base.size() == 1 && structure.base[0] == i;
        const char* const what = is_memory ? "memory" : structure.members[i].by_reference ? "given" : "member";
        part(what, structure.members[i].name, names.members[i] + "()");
    }
    out.close();
}

void print_description(const Unit& unit, Writer& out, const std::vector<ir::StructField>& fields,
                       const std::vector<std::string>& names) {
    if (fields.empty()) return;
    out.open("template <class See> void describe(See&& see) const");
    for (std::size_t i = 0; i < fields.size(); ++i)
        out.line("see.value(" + quoted(unit.name(fields[i].name)) + ", " + names[i] + ");");
    out.close();
}

}  // namespace gliftc::cpp
