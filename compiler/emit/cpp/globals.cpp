// Names for the structs and structures of a program.
#include "emit/cpp/printer.h"
#include "ir/aliases.h"

#include <unordered_map>

namespace gliftc::cpp {

Globals make_globals(const ir::Program& program, const Sources& sources, std::uint32_t module) {
    Globals globals(program, sources);
    const Names& names = *program.names;
    std::vector<Name> aliases;
    for (const ir::Structure& each : program.structures) aliases.push_back(ir::name_in(program, each, module));
    std::unordered_map<std::uint32_t, int> uses;
    for (const ir::Struct& each : program.structs) ++uses[each.name.index];
    for (std::size_t i = 0; i < aliases.size(); ++i)
        ++uses[aliases[i] ? aliases[i].index : program.structures[i].name.index];
    for (const ir::Struct& each : program.structs) {
        if (!each.extern_name.empty()) globals.struct_names.push_back("::" + each.extern_name);
        else if (uses[each.name.index] > 1) globals.struct_names.push_back(globals.names.declare(each.display));
        else globals.struct_names.push_back(globals.names.declare(names[each.name]));
    }
    // Aliases first: they are what users write.
    globals.structure_names.resize(program.structures.size());
    globals.other_names.resize(program.structures.size());
    for (std::size_t i = 0; i < aliases.size(); ++i) {
        if (aliases[i]) globals.structure_names[i] = globals.names.declare(names[aliases[i]]);
        for (Name name : ir::public_names(program.structures[i], module))
            if (name != aliases[i]) globals.other_names[i].push_back(globals.names.declare(names[name]));
    }
    for (std::size_t i = 0; i < program.structures.size(); ++i) {
        const ir::Structure& each = program.structures[i];
        if (aliases[i]) continue;
        const bool generic = each.display.find('<') != std::string::npos;
        globals.structure_names[i] = globals.names.declare(generic ? each.display : names[each.name]);
    }
    for (std::uint32_t i = 0; i < program.structures.size(); ++i)
        globals.class_names.push_back(class_names(program, i));
    return globals;
}

}  // namespace gliftc::cpp
