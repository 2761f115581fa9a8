// A key of what a structure keeps and where: equal for structures whose states mean the same, whatever their elements
// and the layout of these. Files compare it where the names of two types differ.
#include "emit/cpp/unit.h"
#include "ir/evaluate.h"
#include "ir/print.h"

#include <cstdint>
#include <optional>
#include <string>

namespace gliftc::cpp {

namespace {

std::string place_text(const ir::Place& place) {
    std::string text;
    for (std::uint32_t member : place.members) text += "." + std::to_string(member);
    return text;
}

/// An expression as text; of a choice between two values that constants decide, the value that is taken.
std::string value_text(const ir::Program& program, ir::ExprId value) {
    while (program.exprs[value].op == ir::Op::select) {
        const ir::Expr& choice = program.exprs[value];
        const std::optional<ir::Value> condition = ir::evaluate(program, choice.operands[0]);
        if (!condition) break;
        value = choice.operands[condition->lanes[0].bits != 0 ? 1 : 2];
    }
    return ir::print(program, value);
}

std::string stage_text(const ir::Program& program, const ir::Stage& stage) {
    const ir::Translator& translator = program.translators[stage.translator];
    std::string text = ";via " + translator.display + ir::print(program, translator.translate);
    for (const ir::ExprId scalar : stage.scalars) text += "," + value_text(program, scalar);
    for (const ir::Place& place : stage.structures) text += "," + place_text(place);
    return text;
}

/// All that decides where the structure's elements lie and what its members mean, in words that do not depend on the
/// rest of the program.
std::string state_text(const Unit& unit, ir::StructureId index) {
    const ir::Program& program = unit.program;
    const ir::Structure& structure = program.structures[index];
    std::string text = structure.kind == ir::StructureKind::no_elements ? "{" : "{" + unit.type(structure.domain_type);
    for (const ir::LocalId argument : structure.constructor)
        text += ";argument " + unit.name(program.locals[argument].name);
    for (const ir::HostField& field : structure.host) text += ";host " + unit.name(field.name) + unit.type(field.type);
    for (const ir::Memory& memory : structure.memories)
        if (memory.declared)
            text += ";memory " + unit.name(memory.declared) + std::to_string(static_cast<int>(memory.shape)) + "," +
                    std::to_string(static_cast<int>(memory.format)) + "," + value_text(program, memory.extent);
    for (const ir::MemberStructure& member : structure.members) {
        if (member.is_component) continue;
        text += ";member " + unit.name(member.name) + state_text(unit, member.structure);
        for (const ir::ExprId argument : member.arguments) text += "," + value_text(program, argument);
        for (const ir::Place& place : member.structures) text += "," + place_text(place);
    }
    for (const ir::Stage& stage : structure.via) text += stage_text(program, stage);
    for (const std::uint32_t member : structure.base) text += ";base " + std::to_string(member);
    return text + "}";
}

/// FNV-1a: the same on every machine.
std::uint64_t hash_of(const std::string& text) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return hash;
}

}  // namespace

std::uint64_t state_key(const Unit& unit, ir::StructureId structure) { return hash_of(state_text(unit, structure)); }

}  // namespace gliftc::cpp
