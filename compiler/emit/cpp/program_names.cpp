// The names of structs, classes and functions, each in the namespace of its module.
#include "emit/cpp/printer.h"
#include "ir/evaluate.h"

#include <algorithm>
#include <cstdio>
#include <map>

namespace gliftc::cpp {

namespace {

constexpr std::size_t longest_name = 48;

/// Names that all or some generated classes of the kind, or their base classes, use for members, parameters and
/// template parameters.
NameSet members_of_class(ir::StructureKind kind) {
    NameSet names{"address", "box",        "commands",  "describe",  "domain",     "other",
                  "range",   "same_state", "type_name", "value",     "Arguments",  "See",
                  "see",     "Visit",      "visit",     "state_key", "visit_state"};
    switch (kind) {
    case ir::StructureKind::stored:
        names.insert({"Address",
                      "Element",
                      "Place",
                      "Structure",
                      "box_description",
                      "check",
                      "copy_from",
                      "copy_in",
                      "copy_out",
                      "count",
                      "device",
                      "device_",
                      "device_of",
                      "each_part",
                      "element",
                      "element_in_place",
                      "fetch",
                      "fill",
                      "first",
                      "has_blocks",
                      "block_extent",
                      "index_of",
                      "index_memory",
                      "list",
                      "map",
                      "not_recording",
                      "place",
                      "put",
                      "read",
                      "read_list",
                      "read_resident",
                      "row_memory",
                      "self",
                      "throw_count",
                      "translate",
                      "translates",
                      "write"});
        break;
    case ir::StructureKind::computed: names.insert({"Address", "Element", "View", "copy_out", "first"}); break;
    case ir::StructureKind::no_elements:
        names.erase("domain");
        names.erase("range");
        names.insert({"device", "device_"});
        break;
    }
    return names;
}

/// Names that no struct, class or alias may have: members and variables of generated code have them, and would hide the
/// type. Enums may have them: as types they are printed as uint.
const NameSet& not_for_types() {
    static const NameSet names = [] {
        NameSet all = members_of_class(ir::StructureKind::stored);
        all.merge(members_of_class(ir::StructureKind::computed));
        all.merge(members_of_class(ir::StructureKind::no_elements));
        all.insert(std::begin(locals_of_kernels), std::end(locals_of_kernels));
        all.insert(std::begin(locals_of_groups), std::end(locals_of_groups));
        all.insert(std::begin(locals_of_draws), std::end(locals_of_draws));
        all.insert({"iteration", "memories", "structure", "test"});
        return all;
    }();
    return names;
}

/// Whether the class needs an accessor for the memory's name beside those of its members: if the memory is a member
/// with another name (`memory frames = pool;`), or a member of a member (`memory frames = pool.frames;`).
bool has_named_base(const ir::Structure& structure) {
    if (structure.base.empty()) return false;
    return structure.base.size() > 1 || structure.members[structure.base[0]].name != structure.base_name;
}

/// FNV-1a: the same on every machine.
std::uint32_t hash_of(const std::string& text) {
    std::uint32_t hash = 2166136261u;
    for (char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash;
}

/// Whether generic arguments stay distinct, but for rare cases, when all but letters and digits becomes '_':
/// `<2, grid.Cell>` do, but not `<-1>`, `<A<2>>`, `<a_b>`.
bool is_plain(std::string_view arguments) {
    return std::ranges::all_of(arguments.substr(1, arguments.size() - 2), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ',' || c == ' ' ||
               c == '.';
    });
}

/// `Array_2_grid_Cell` for the key `std.array.Array<2, grid.Cell>`; where that name is long, or other keys may give it,
/// too, a name with a hash of the key: `choose_by_5d1f3a2c`.
std::string name_of_instance(const std::string& name, const std::string& key) {
    const std::size_t arguments = key.find('<');
    if (arguments == std::string::npos) return identifier(name);
    const std::string_view text = std::string_view(key).substr(arguments);
    const std::string all = identifier(name + std::string(text));
    if (is_plain(text) && all.size() <= longest_name) return all;
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08x", hash_of(key));
    return identifier(name + "_" + digits);
}

ClassNames class_names(const ir::Program& program, const NameSet& types, const ir::Structure& structure) {
    const NameSet fixed = members_of_class(structure.kind);
    Scopes scopes;
    scopes.avoid(types);
    scopes.avoid(fixed);
    ClassNames names;
    const auto text = [&](Name name) { return scopes.declare((*program.names)[name]); };
    for (ir::LocalId local : structure.constructor) names.arguments.push_back(text(program.locals[local].name));
    for (const ir::MemberStructure& member : structure.members) names.members.push_back(text(member.name));
    if (has_named_base(structure)) names.base = text(structure.base_name);
    for (const ir::Memory& memory : structure.memories) names.memories.push_back(text(memory.name));
    for (const ir::HostField& field : structure.host) names.host.push_back(text(field.name));
    // Overloads share a name. Instances of a generic pipeline may have the same parameters, so that their names
    // include the generic arguments (name_of_instance).
    std::unordered_map<std::string, std::string> overloads;
    const auto overloaded = [&](const std::string& wanted) {
        std::string& name = overloads[wanted];
        if (name.empty()) name = scopes.declare(wanted);
        return name;
    };
    for (ir::PipelineId index : structure.pipelines) {
        const ir::Pipeline& pipeline = program.pipelines[index];
        names.pipelines.push_back(overloaded(name_of_instance((*program.names)[pipeline.name], pipeline.key)));
    }
    for (const ir::Method& method : structure.methods)
        names.methods.push_back(overloaded((*program.names)[program.functions[method.function].name]));
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
                             &names.host_fields, &names.pipelines, &names.methods})
        names.own.insert(list->begin(), list->end());
    names.all = names.own;
    for (const auto* list : {&names.arguments, &names.members, &names.memories, &names.host, &names.extents})
        names.all.insert(list->begin(), list->end());
    if (!names.base.empty()) names.all.insert(names.base);
    return names;
}

/// Names of a struct's fields. Those of a struct from a user's header stay as they are.
std::vector<std::string> field_names(const ir::Program& program, const NameSet& types, const ir::Struct& type) {
    static const NameSet fixed = {"See", "describe", "former_names", "see"};
    Scopes scopes;
    scopes.avoid(types);
    scopes.avoid(fixed);
    std::vector<std::string> names;
    for (const ir::StructField& field : type.fields) {
        const std::string& name = (*program.names)[field.name];
        names.push_back(type.extern_header.empty() ? scopes.declare(name) : name);
    }
    return names;
}

/// Declares all names, types first.
struct Naming {
    const ir::Program& program;
    ProgramNames names;
    std::map<std::string, std::string> kernels, pipelines;  ///< by key, which overloads of a pipeline share

    const std::string& text(Name name) const { return (*program.names)[name]; }

    std::string type(ir::ModuleId module, const std::string& wanted) {
        std::string name = wanted;
        // Two underscores in a row are reserved in C++.
        if (not_for_types().contains(name)) name += name.ends_with('_') ? "2" : "_";
        if (not_for_types().contains(name)) name += '2';
        name = names.taken[module].declare(name);
        names.types[module].insert(name);
        return name;
    }

    void types() {
        for (const ir::Struct& each : program.structs)
            names.structs.push_back(type(each.module, name_of_instance(text(each.name), each.key)));
        for (const ir::Structure& each : program.structures) {
            names.structures.push_back(type(each.module, name_of_instance(text(each.name), each.key)));
            names.aliases.emplace_back();
        }
        for (ir::StructureId i : program.structures.ids()) {
            const ir::Structure& each = program.structures[i];
            for (const ir::Alias& alias : each.aliases) {
                const bool is_its_name = alias.name == each.name && alias.module == each.module;
                names.aliases[i].push_back(is_its_name ? names.structures[i] : type(alias.module, text(alias.name)));
            }
        }
        for (const ir::Enum& each : program.enums)
            names.enums.push_back(names.taken[each.module].declare(text(each.name)));
        for (const ir::Struct& each : program.structs)
            names.fields.push_back(field_names(program, names.types[each.module], each));
        for (const ir::Structure& each : program.structures)
            names.classes.push_back(class_names(program, names.types[each.module], each));
    }

    std::string function(std::map<std::string, std::string>& known, ir::ModuleId module, Name name,
                         const std::string& key) {
        std::string& found = known[key.empty() ? ir::module_text(program, module) + text(name) : key];
        if (found.empty()) found = names.taken[module].declare(name_of_instance(text(name), key));
        return found;
    }

    void kernels_that_are(bool is_pub) {
        for (ir::KernelId i : program.kernels.ids()) {
            const ir::Kernel& each = program.kernels[i];
            if (each.is_pub != is_pub) continue;
            const std::string key =
                each.is_instance ? ir::module_text(program, each.module) + "." + text(each.name) : each.key;
            names.kernels[i] = function(kernels, each.module, each.name, key);
        }
    }

    /// Public kernels are named before pipelines and other kernels, so that they get the names that users wrote.
    void functions() {
        names.kernels.resize(program.kernels.size());
        kernels_that_are(true);
        for (const ir::Pipeline& each : program.pipelines)
            names.pipelines.push_back(each.owner ? "" : function(pipelines, each.module, each.name, each.key));
        for (ir::StructureId i : program.structures.ids())
            for (std::size_t k = 0; k < program.structures[i].pipelines.size(); ++k)
                names.pipelines[program.structures[i].pipelines[k]] = names.classes[i].pipelines[k];
        kernels_that_are(false);
    }
};

}  // namespace

ProgramNames program_names(const ir::Program& program) {
    Naming naming{program, {}, {}, {}};
    for (const ir::Module& module : program.modules)
        naming.names.spaces.push_back(space_of((*program.names)[module.name]));
    naming.names.types.resize(program.modules.size());
    naming.names.taken.resize(program.modules.size());
    naming.types();
    naming.functions();
    return std::move(naming.names);
}

}  // namespace gliftc::cpp
