// Names for the structs and structures of a program.
#include "emit/cpp/printer.h"

#include <unordered_map>

namespace gliftc::cpp {

Globals make_globals(const ir::Program& program, const Sources& sources) {
    Globals globals(program, sources);
    const Names& names = *program.names;
    std::unordered_map<std::uint32_t, int> uses;
    for (const ir::Struct& each : program.structs) ++uses[each.name.index];
    for (const ir::Structure& each : program.structures) ++uses[each.alias ? each.alias.index : each.name.index];
    for (const ir::Struct& each : program.structs) {
        if (!each.extern_name.empty()) globals.struct_names.push_back("::" + each.extern_name);
        else if (uses[each.name.index] > 1) globals.struct_names.push_back(globals.names.declare(each.display));
        else globals.struct_names.push_back(globals.names.declare(names[each.name]));
    }
    // Aliases first: they are what users write.
    globals.structure_names.resize(program.structures.size());
    for (std::size_t i = 0; i < program.structures.size(); ++i) {
        const ir::Structure& each = program.structures[i];
        if (each.alias) globals.structure_names[i] = globals.names.declare(names[each.alias]);
    }
    for (std::size_t i = 0; i < program.structures.size(); ++i) {
        const ir::Structure& each = program.structures[i];
        if (each.alias) continue;
        const bool generic = each.display.find('<') != std::string::npos;
        globals.structure_names[i] = globals.names.declare(generic ? each.display : names[each.name]);
    }
    for (std::uint32_t i = 0; i < program.structures.size(); ++i)
        globals.class_names.push_back(class_names(program, i));
    return globals;
}

}  // namespace gliftc::cpp
