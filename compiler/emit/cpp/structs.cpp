// Structs as structs; enums as structs with an unscoped enum in them, whose underlying type is uint.
#include "emit/cpp/unit.h"
#include "ir/empty.h"
#include "layout/layout.h"

#include <algorithm>

namespace gliftc::cpp {

void print_enum(const Unit& unit, Writer& out, ir::EnumId id) {
    const ir::Enum& type = unit.program.enums[id];
    write_doc(out, type.doc);
    out.open("struct " + unit.own.enums[id]);
    std::string list;
    const NameSet type_name{unit.own.enums[id]};
    Scopes names;
    names.avoid(type_name);
    for (std::size_t i = 0; i < type.enumerators.size(); ++i)
        list +=
            (i ? ", " : "") + names.declare(unit.name(type.enumerators[i])) + " = " + std::to_string(type.values[i]);
    out.line("enum : glift::uint { " + list + " };");
    out.close(";");
    out.gap();
}

void print_struct(const Unit& unit, Writer& out, ir::StructId id) {
    const ir::Struct& type = unit.program.structs[id];
    const std::string name = type.extern_header.empty() ? unit.own.structs[id] : "::" + type.extern_name;
    const std::vector<std::string>& fields = unit.globals.field_names[id];
    const std::vector<std::uint32_t> offsets = layout::offsets_of(unit.program, type);
    if (type.extern_header.empty()) {
        write_doc(out, type.doc);
        out.open("struct " + name);
        for (std::size_t i = 0; i < type.fields.size(); ++i) {
            write_doc(out, type.fields[i].doc);
            out.line(storage_text(unit.globals, type.fields[i].type, true) + " " + fields[i] + "{};");
        }
        out.line("bool operator==(const " + name + "&) const = default;");
        print_description(unit, out, type.fields, fields);
        out.close(";");
    }
    // A struct with a field of an empty type is never in memory, so its offsets do not matter.
    const bool is_in_memory = std::none_of(type.fields.begin(), type.fields.end(), [&](const ir::StructField& field) {
        return ir::holds_empty(unit.program, field.type);
    });
    for (std::size_t i = 0; i < type.fields.size() && is_in_memory; ++i)
        out.line("static_assert(offsetof(" + name + ", " + fields[i] + ") == " + std::to_string(offsets[i]) + ");");
    if (!type.extern_header.empty())
        out.line("static_assert(sizeof(" + name + ") == " + std::to_string(type.size) + ");");
    out.gap();
}

}  // namespace gliftc::cpp
