#include "ir/aliases.h"

#include <algorithm>
#include <set>
#include <string>

namespace gliftc::ir {

std::vector<Name> public_names(const Structure& structure, ModuleId module) {
    std::vector<Name> names;
    for (const Alias& alias : structure.aliases)
        if (alias.is_pub && alias.module == module) names.push_back(alias.name);
    return names;
}

bool is_public(const Structure& structure, ModuleId module) {
    return std::ranges::any_of(structure.aliases,
                               [&](const Alias& alias) { return alias.is_pub && alias.module == module; });
}

Name name_in(const Program& program, const Structure& structure, ModuleId module) {
    enum Rank { own_public, own, imported, foreign };
    const auto rank_of = [&](const Alias& alias) {
        if (alias.module == module) return alias.is_pub ? own_public : own;
        return std::ranges::binary_search(program.modules[module].imports, alias.module) ? imported : foreign;
    };
    const auto best = std::ranges::min_element(structure.aliases, {}, rank_of);  // the first of several
    return best == structure.aliases.end() || rank_of(*best) == foreign ? Name{} : best->name;
}

std::vector<FunctionId> public_functions(const Program& program, StructureId structure) {
    std::vector<FunctionId> found;
    std::set<std::string> names;
    const auto add = [&](FunctionId id) {
        const Function& function = program.functions[id];
        const bool is_its = function.structures.size() == 1 && function.structures[0] == structure;
        if (!function.is_pub || !is_its) return;
        std::string name = function.key;  // overloads have the same key
        for (LocalId param : function.params) name += " " + std::to_string(program.locals[param].type.index);
        if (names.insert(std::move(name)).second) found.push_back(id);
    };
    for (const Method& method : program.structures[structure].methods) add(method.function);
    for (std::size_t i = 0; i < program.functions.size(); ++i) add(FunctionId{static_cast<std::uint32_t>(i)});
    return found;
}

}  // namespace gliftc::ir
