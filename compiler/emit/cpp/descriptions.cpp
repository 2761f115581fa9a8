// The functions `describe` of generated classes and structs, which names their parts to programs that inspect
// structures of any type, and `visit_state` of classes, which hands what a structure consists of to programs that store
// and restore it.
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

namespace {

/// The types of the constructor's arguments, by which a structure is made from stored ones. Not of structures that are
/// given others: a file cannot say which.
void print_argument_types(const Unit& unit, Writer& out, const ir::Structure& structure) {
    for (const ir::MemberStructure& member : structure.members)
        if (member.by_reference) return;
    std::string types;
    for (const ir::LocalId argument : structure.constructor)
        types += (types.empty() ? "" : ", ") + unit.type(unit.program.locals[argument].type, true);
    out.line("using Arguments = glift::Types<" + types + ">;");
}

/// The name of a buffer in files: that of its declaration; if it has one field alone of the elements, `data.velocity`.
/// `former`: with the former names of fields.
std::string stored_name(const Unit& unit, const ir::Structure& structure, std::size_t memory, bool former = false) {
    std::size_t first = memory;
    while (!structure.memories[first].declared) --first;
    std::string name = unit.name(structure.memories[first].declared);
    ir::TypeId type = structure.element;
    for (const std::uint32_t field : structure.memories[memory].fields) {
        const ir::StructField& part = unit.program.structs[unit.program.types[type].struct_].fields[field];
        name += "." + unit.name(former && part.former ? part.former : part.name);
        type = part.type;
    }
    return name;
}

}  // namespace

void print_state_visit(const Unit& unit, Writer& out, ir::StructureId index) {
    const ir::Structure& structure = unit.program.structures[index];
    const ClassNames& names = unit.globals.class_names[index];
    const auto stored = [&](const char* what, const std::string& name, const std::string& fields) {
        out.line(std::string("visit.") + what + "(" + quoted(name) + ", " + fields + ");");
    };
    const auto part = [&](const char* what, Name name, const std::string& fields) {
        stored(what, unit.name(name), fields);
    };
    print_argument_types(unit, out, structure);
    out.line("static constexpr std::uint64_t state_key = " + std::to_string(state_key(unit, index)) + "u;");
    out.open("template <class Visit> void visit_state(Visit&& visit)");
    for (std::size_t i = 0; i < structure.constructor.size(); ++i)
        part("argument", unit.program.locals[structure.constructor[i]].name, names.argument_fields[i]);
    for (std::size_t i = 0; i < structure.host.size(); ++i)
        part("host", structure.host[i].name, names.host_fields[i] + ".get()");
    for (std::size_t i = 0; i < structure.memories.size(); ++i) {
        const ir::Memory& memory = structure.memories[i];
        if (memory.part) continue;
        const bool is_buffer = memory.shape == ir::MemoryShape::buffer;
        const std::string name = stored_name(unit, structure, i), former = stored_name(unit, structure, i, true);
        stored(is_buffer ? "buffer" : "image", name,
               names.memory_fields[i] + ", " + names.extent_fields[i] +
                   (is_buffer ? ", " + storage_text(unit.globals, memory.element, true) + "{}" : "") +
                   (former == name ? "" : ", " + quoted(former)));
    }
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        if (structure.members[i].is_component) continue;
        const bool is_memory = structure.base.size() == 1 && structure.base[0] == i;
        const char* const what = structure.members[i].by_reference ? "given" : is_memory ? "base" : "member";
        part(what, structure.members[i].name,
             names.member_fields[i] + (is_held_by_handle(structure, i) ? ".get()" : ""));
    }
    out.close();
}

void print_description(const Unit& unit, Writer& out, const std::vector<ir::StructField>& fields,
                       const std::vector<std::string>& names) {
    if (fields.empty()) return;
    std::string former;
    for (std::size_t i = 0; i < fields.size(); ++i)
        if (fields[i].former)
            former += (former.empty() ? "{" : ", {") + quoted(unit.name(fields[i].name)) + ", " +
                      quoted(unit.name(fields[i].former)) + "}";
    if (!former.empty()) out.line("static constexpr const char* former_names[][2] = {" + former + "};");
    out.open("template <class See> void describe(See&& see) const");
    for (std::size_t i = 0; i < fields.size(); ++i)
        out.line("see.value(" + quoted(unit.name(fields[i].name)) + ", " + names[i] + ");");
    out.close();
}

}  // namespace gliftc::cpp
