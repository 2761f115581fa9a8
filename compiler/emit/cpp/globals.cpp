// Names for the enums, structs and structures of a program, and for what the classes and structs have.
#include "emit/cpp/printer.h"
#include "ir/aliases.h"

#include <algorithm>
#include <unordered_map>

namespace gliftc::cpp {

namespace {

/// What every generated class of the kind has, with what it has from its base.
NameSet members_of_class(ir::StructureKind kind) {
    NameSet names{"address", "box", "commands", "domain", "other", "range", "same_state", "type_name", "value"};
    switch (kind) {
    case ir::StructureKind::stored:
        names.insert({"Address",     "Element",
                      "Structure",   "box_description",
                      "check",       "copy_from",
                      "copy_in",     "copy_out",
                      "count",       "device",
                      "device_",     "device_of",
                      "element",     "element_in_place",
                      "fetch",       "fill",
                      "first",       "map",
                      "place",       "read",
                      "row_memory",  "self",
                      "throw_count", "translate",
                      "write"});
        break;
    case ir::StructureKind::view: names.insert({"Address", "Element", "View", "first"}); break;
    case ir::StructureKind::adaptor:
        names.erase("domain");
        names.erase("range");
        names.insert({"device", "device_"});
        break;
    }
    return names;
}

/// A type of such a name would not be found where generated code calls a member or a variable so.
const NameSet& not_for_types() {
    static const NameSet names = [] {
        NameSet all = members_of_class(ir::StructureKind::stored);
        all.merge(members_of_class(ir::StructureKind::view));
        all.merge(members_of_class(ir::StructureKind::adaptor));
        all.insert(std::begin(locals_of_kernels), std::end(locals_of_kernels));
        all.insert(std::begin(locals_of_groups), std::end(locals_of_groups));
        all.insert({"iteration", "memories", "structure", "test"});
        return all;
    }();
    return names;
}

/// What argument-dependent lookup would find in the runtime for arguments that are its vectors and arrays.
const NameSet& functions_of_runtime() {
#define INTRINSIC(name, signature, exactness) #name,
    static const NameSet names = {
#include "ir/intrinsics.def"
        "as_array",      "assign_swizzle", "bytes_of",    "convert",  "divide",
        "element_count", "half_bits",      "half_value",  "minor_of", "remainder",
        "reset",         "shift_left",     "shift_right", "spread",   "swizzle",
    };
#undef INTRINSIC
    return names;
}

std::string declare_type(Globals& globals, std::string_view wanted) {
    std::string name = identifier(wanted);
    if (not_for_types().contains(name)) name += '_';
    name = globals.names.declare(name);
    globals.type_names.insert(name);
    return name;
}

ClassNames class_names(const Globals& globals, const ir::Structure& structure) {
    const ir::Program& program = globals.program;
    const NameSet fixed = members_of_class(structure.kind);
    Scopes scopes;
    scopes.avoid(globals.type_names);
    scopes.avoid(fixed);
    ClassNames names;
    const auto text = [&](Name name) { return scopes.declare((*program.names)[name]); };
    for (ir::LocalId local : structure.constructor) names.arguments.push_back(text(program.locals[local].name));
    for (const ir::MemberStructure& member : structure.members) names.members.push_back(text(member.name));
    for (const ir::Memory& memory : structure.memories) names.memories.push_back(text(memory.name));
    for (const ir::HostField& field : structure.host) names.host.push_back(text(field.name));
    std::unordered_map<std::uint32_t, std::string> overloads;
    for (std::uint32_t pipeline : structure.pipelines) {
        std::string& name = overloads[program.pipelines[pipeline].name.index];
        if (name.empty()) name = text(program.pipelines[pipeline].name);
        names.pipelines.push_back(name);
    }
    const auto also = [&](const std::vector<std::string>& of, const char* ending, std::vector<std::string>& made) {
        for (const std::string& name : of) made.push_back(scopes.declare(name + ending));
    };
    also(names.memories, "_extent", names.extents);
    also(names.arguments, "_", names.argument_fields);
    also(names.members, "_", names.member_fields);
    also(names.memories, "_", names.memory_fields);
    also(names.extents, "_", names.extent_fields);
    also(names.host, "_", names.host_fields);
    names.own = fixed;
    for (const auto* list : {&names.argument_fields, &names.member_fields, &names.memory_fields, &names.extent_fields,
                             &names.host_fields, &names.pipelines})
        names.own.insert(list->begin(), list->end());
    names.all = names.own;
    for (const auto* list : {&names.arguments, &names.members, &names.memories, &names.host, &names.extents})
        names.all.insert(list->begin(), list->end());
    return names;
}

/// Those of a struct from a user's header are what they are.
std::vector<std::string> field_names(const Globals& globals, const ir::Struct& type) {
    Scopes scopes;
    scopes.avoid(globals.type_names);
    std::vector<std::string> names;
    for (const ir::StructField& field : type.fields) {
        const std::string& name = (*globals.program.names)[field.name];
        names.push_back(type.extern_header.empty() ? scopes.declare(name) : name);
    }
    return names;
}

void name_structs(Globals& globals, const std::vector<Name>& aliases) {
    const ir::Program& program = globals.program;
    const Names& names = *program.names;
    std::unordered_map<std::uint32_t, int> uses;
    for (const ir::Struct& each : program.structs) ++uses[each.name.index];
    for (std::size_t i = 0; i < aliases.size(); ++i)
        ++uses[aliases[i] ? aliases[i].index : program.structures[i].name.index];
    for (const ir::Struct& each : program.structs) {
        if (!each.extern_name.empty()) globals.struct_names.push_back("::" + each.extern_name);
        else if (uses[each.name.index] > 1) globals.struct_names.push_back(declare_type(globals, each.display));
        else globals.struct_names.push_back(declare_type(globals, names[each.name]));
    }
}

void name_structures(Globals& globals, const std::vector<Name>& aliases, std::uint32_t module) {
    const ir::Program& program = globals.program;
    const Names& names = *program.names;
    globals.structure_names.resize(program.structures.size());
    globals.other_names.resize(program.structures.size());
    // Aliases first: they are what users write.
    for (std::size_t i = 0; i < aliases.size(); ++i) {
        if (aliases[i]) globals.structure_names[i] = declare_type(globals, names[aliases[i]]);
        for (Name name : ir::public_names(program.structures[i], module))
            if (name != aliases[i]) globals.other_names[i].push_back(declare_type(globals, names[name]));
    }
    for (std::size_t i = 0; i < program.structures.size(); ++i) {
        const ir::Structure& each = program.structures[i];
        if (aliases[i]) continue;
        const bool generic = each.display.find('<') != std::string::npos;
        globals.structure_names[i] = declare_type(globals, generic ? each.display : names[each.name]);
    }
}

}  // namespace

Globals make_globals(const ir::Program& program, const Sources& sources, std::uint32_t module) {
    Globals globals(program, sources);
    const Names& names = *program.names;
    globals.space = space_of(names[program.modules[module].name]);
    std::vector<Name> aliases;
    for (const ir::Structure& each : program.structures) aliases.push_back(ir::name_in(program, each, module));
    name_structs(globals, aliases);
    name_structures(globals, aliases, module);
    for (const ir::Enum& each : program.enums) globals.enum_names.push_back(globals.names.declare(names[each.name]));
    for (const ir::Struct& each : program.structs) globals.field_names.push_back(field_names(globals, each));
    for (const ir::Structure& each : program.structures) globals.class_names.push_back(class_names(globals, each));
    return globals;
}

std::string declare_function(Globals& globals, ir::FunctionId function) {
    std::string name = identifier((*globals.program.names)[globals.program.functions[function].name]);
    if (functions_of_runtime().contains(name)) name += '_';
    return globals.names.declare(name);
}

std::vector<std::string> block_names(const Globals& globals, const ir::Pass& pass) {
    Scopes scopes;
    scopes.avoid(globals.type_names);
    std::vector<std::string> names;
    for (const ir::PassParameter& parameter : pass.parameters) names.push_back(scopes.declare(parameter.name));
    return names;
}

}  // namespace gliftc::cpp
