// The functions of generated classes that move elements between structures and the host.
#include "emit/cpp/unit.h"
#include "ir/chain.h"

namespace gliftc::cpp {

namespace {

const ir::Program::Transfer* transfer_of(const ir::Program& program, ir::StructureId structure) {
    for (const ir::Program::Transfer& transfer : program.transfers) {
        if (transfer.structure == structure) return &transfer;
    }
    return nullptr;
}

/// The parameters of the function that lists the resident elements of a box.
std::string list_parameters(const std::string& type) {
    return "(const glift::Commands& commands, const glift::Range<" + type +
           ">& range, glift::uint most, const glift::Memory& counter, const glift::Memory& addresses, const "
           "glift::Memory& places, const glift::Memory& values) const";
}

/// The type of places: the physical addresses to which a structure's addresses are translated.
std::string place_type(const Unit& unit, const ir::Structure& structure, bool qualified) {
    const ir::Structure& translated =
        ir::structure_at(unit.program, structure, ir::translated_by(unit.program, structure));
    const ir::TypeId type = ir::physical_type(unit.program, translated);
    return unit.type(type ? type : structure.domain_type, qualified);
}

/// The structure that translates addresses to places, within the class.
std::string translated_text(const Unit& unit, ir::StructureId index) {
    std::string text;
    ir::StructureId at = index;
    for (std::uint32_t member : ir::translated_by(unit.program, unit.program.structures[index])) {
        text += (text.empty() ? "" : ".") + unit.globals.class_names[at].members[member] + "()";
        at = unit.program.structures[at].members[member].structure;
    }
    return text.empty() ? "*this" : text;
}

}  // namespace

void print_list_declaration(const Unit& unit, Writer& out, ir::StructureId index) {
    const ir::Structure& structure = unit.program.structures[index];
    if (!ir::has_resident_part(unit.program, structure)) return;
    const bool has_blocks = ir::blocks_of(unit.program, structure, {}).has_value();
    out.line("/// The type of the physical addresses to which addresses are translated.");
    out.line("using Place = " + place_type(unit, structure, true) + ";");
    out.line("/// Whether the structure has translators itself; else its memory, a structure, translates.");
    out.line(std::string("static constexpr bool translates = ") + (structure.via.empty() ? "false;" : "true;"));
    out.line(std::string("static constexpr bool has_blocks = ") + (has_blocks ? "true" : "false") + ";");
    out.line(
        "/// Counts the resident elements of a box, and lists at most `most` of them in any order: see read_resident.");
    out.line("void list" + list_parameters(unit.own_name(index)) + ";");
}

void print_transfers(Unit& unit, Writer& out, ir::StructureId index) {
    const ir::Program::Transfer* transfer = transfer_of(unit.program, index);
    if (!transfer) return;
    const std::string& type = unit.own_name(index);
    const char* const linkage = unit.linkage(unit.program.structures[index].key);
    const std::string& box = unit.class_name(transfer->box_structure);
    const std::string parameters =
        "(const glift::Commands& commands, const glift::Range<" + type + ">& range, const glift::Memory& box) const";
    const std::string made = box + "(commands, range.size(), box)";
    Printer p(unit.globals);
    p.class_names = &unit.globals.class_names[index].all;
    const auto kernel = [&](ir::KernelId called) { return visible(p, unit.globals.kernel_names[called]); };
    out.open(linkage + ("void " + type) + "::copy_out" + parameters);
    out.line(kernel(transfer->read_kernel) + "(commands, range, " + made + ");");
    out.close();
    out.gap();
    if (transfer->list_kernel) {
        out.open(linkage + ("void " + type) + "::list" + list_parameters(type));
        const auto list = [&](ir::StructureId made, const std::string& length, const std::string& memory) {
            return unit.class_name(made) + "(commands, " + length + ", " + memory + ")";
        };
        out.line(kernel(transfer->list_kernel) + "(commands, range, *this, " + translated_text(unit, index) + ", " +
                 list(transfer->counter, "1", "counter") + ", " + list(transfer->addresses, "most", "addresses") +
                 ", " + list(transfer->places, "most", "places") + ", " + list(transfer->values, "most", "values") +
                 ");");
        out.close();
        out.gap();
    }
    if (transfer->write_kernel) {
        out.open(linkage + ("void " + type) + "::copy_in" + parameters);
        out.line(kernel(transfer->write_kernel) + "(commands, " + made + ", range);");
        out.close();
        out.gap();
    }
    if (transfer->fill_kernel) {
        const std::string element = unit.type(unit.program.structures[index].element);
        out.open(linkage + ("void " + type) + "::fill(" + element + " value, const glift::Range<" + type + ">& range)");
        out.line(kernel(transfer->fill_kernel) + "(device(), range, value);");
        out.close();
        out.open(linkage + ("void " + type) + "::fill(" + element + " value)");
        out.line("fill(value, *this);");
        out.close();
        out.gap();
    }
}

}  // namespace gliftc::cpp
