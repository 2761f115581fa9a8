// How the properties of structures are spelled: through the members of their generated classes.
#include "base/concat.h"
#include "emit/cpp/printer.h"

namespace gliftc::cpp {

std::string visible(const Printer& p, const std::string& name) {
    const bool hidden = p.names.holds(name) || (p.class_names && p.class_names->contains(name));
    return hidden ? concat("::", p.globals.space, "::", name) : name;
}

bool is_held_by_handle(const ir::Structure& structure, std::size_t member) {
    return structure.is_container && is_held(structure.members[member]);
}

// long: a case for each operation
Text structure_property(const Globals& globals, const ir::Expr& expr, ir::StructureId root_structure,
                        const std::string& object) {
    ir::StructureId structure = root_structure;
    std::string prefix = object;
    bool own = object.empty();  // the fields themselves, not their accessors
    for (std::uint32_t member : expr.place.members) {
        const ClassNames& names = globals.class_names[structure];
        own = own && !globals.program.structures[structure].members[member].is_component;
        const bool is_handle = own && is_held_by_handle(globals.program.structures[structure], member);
        prefix += own ? names.member_fields[member] + (is_handle ? ".get()." : ".") : names.members[member] + "().";
        own = false;
        structure = globals.program.structures[structure].members[member].structure;
    }
    const ClassNames& names = globals.class_names[structure];
    switch (expr.op) {
    case ir::Op::member: return {own ? names.argument_fields[expr.slot] : prefix + names.arguments[expr.slot] + "()"};
    case ir::Op::memory_extent: {
        const std::string extent = own ? names.extent_fields[expr.slot] : prefix + names.extents[expr.slot] + "()";
        const ir::Structure& of = globals.program.structures[structure];
        const bool is_cut =
            of.memories[expr.slot].shape == ir::MemoryShape::buffer && expr.type == globals.program.types.uint;
        return {is_cut ? "glift::fitted(" + extent + ")" : extent};
    }
    case ir::Op::host_state:
        return {own ? names.host_fields[expr.slot] + ".get()" : prefix + names.host[expr.slot] + "()"};
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
    case ir::Op::gather:
    case ir::Op::compare:
    case ir::Op::position:
    case ir::Op::window:
    case ir::Op::front_facing:
    case ir::Op::state:
    case ir::Op::translate:
    case ir::Op::invocation:
    case ir::Op::host_read:
    case ir::Op::device_read:
    case ir::Op::await_value:
    case ir::Op::device_value:
    case ir::Op::slice:
    case ir::Op::pipeline_call:
    case ir::Op::device_property:
    case ir::Op::element_count:
    case ir::Op::parameter:
    case ir::Op::guarded_load:
    case ir::Op::load:
    case ir::Op::row_load:
    case ir::Op::row_item:
    case ir::Op::image_load:
    case ir::Op::image_sample:
    case ir::Op::image_gather:
    case ir::Op::image_compare:
    case ir::Op::builtin: break;
    }
    return {"{}"};
}

}  // namespace gliftc::cpp
