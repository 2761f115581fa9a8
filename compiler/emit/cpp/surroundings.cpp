// How the properties of structures are spelled: through the members of their generated classes.
#include "emit/cpp/printer.h"

namespace gliftc::cpp {

ClassNames class_names(const ir::Program& program, std::uint32_t index) {
    const ir::Structure& structure = program.structures[index];
    Scopes scopes;
    for (const char* taken : {"Address",    "Element", "Structure", "copy_from", "copy_in", "copy_out", "count",
                              "domain",     "fill",    "map",       "place",     "range",   "read",     "row_memory",
                              "same_state", "self",    "type_name", "write",     "box",     "other",    "value"})
        scopes.declare(taken);
    ClassNames names;
    const auto text = [&](Name name) { return scopes.declare((*program.names)[name]); };
    for (ir::LocalId local : structure.constructor) names.arguments.push_back(text(program.locals[local].name));
    for (const ir::MemberStructure& member : structure.members) names.members.push_back(text(member.name));
    for (const ir::Memory& memory : structure.memories) names.memories.push_back(text(memory.name));
    for (const ir::HostField& field : structure.host) names.host.push_back(text(field.name));
    return names;
}

Text structure_property(const Globals& globals, const ir::Expr& expr, std::uint32_t root_structure,
                        const std::string& object) {
    std::uint32_t structure = root_structure;
    std::string prefix = object;
    bool own = object.empty();  // the fields themselves, not their accessors
    for (std::uint32_t member : expr.place.members) {
        prefix += globals.class_names[structure].members[member] + (own ? "_." : "().");
        own = false;
        structure = globals.program.structures[structure].members[member].structure;
    }
    const ClassNames& names = globals.class_names[structure];
    const char* end = own ? "_" : "()";
    switch (expr.op) {
    case ir::Op::member: return {prefix + names.arguments[expr.slot] + end};
    case ir::Op::memory_extent: return {prefix + names.memories[expr.slot] + "_extent" + end};
    case ir::Op::host_state: return {prefix + names.host[expr.slot] + end};
    case ir::Op::domain: return {prefix + "domain()"};
    case ir::Op::structure_value:
        if (prefix.ends_with("->")) return {prefix.substr(0, prefix.size() - 2) + ".structure()"};
        if (prefix.empty()) return {"*this", Level::unary};
        return {prefix.substr(0, prefix.size() - 1)};
    case ir::Op::constant:
    case ir::Op::local:
    case ir::Op::construct:
    case ir::Op::convert:
    case ir::Op::unary:
    case ir::Op::binary:
    case ir::Op::select:
    case ir::Op::swizzle:
    case ir::Op::index:
    case ir::Op::field:
    case ir::Op::call:
    case ir::Op::intrinsic:
    case ir::Op::none:
    case ir::Op::some:
    case ir::Op::has_value:
    case ir::Op::value:
    case ir::Op::element:
    case ir::Op::address:
    case ir::Op::near:
    case ir::Op::read:
    case ir::Op::sample:
    case ir::Op::position:
    case ir::Op::state:
    case ir::Op::translate:
    case ir::Op::invocation:
    case ir::Op::host_read:
    case ir::Op::device_read:
    case ir::Op::await_value:
    case ir::Op::slice:
    case ir::Op::pipeline_call:
    case ir::Op::device_property:
    case ir::Op::element_count:
    case ir::Op::parameter:
    case ir::Op::load:
    case ir::Op::image_load:
    case ir::Op::image_sample:
    case ir::Op::builtin: break;
    }
    return {"{}"};
}

}  // namespace gliftc::cpp
