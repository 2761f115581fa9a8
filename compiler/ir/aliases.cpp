#include "ir/aliases.h"

#include <algorithm>

namespace gliftc::ir {

std::vector<Name> public_names(const Structure& structure, std::uint32_t module) {
    std::vector<Name> names;
    for (const Alias& alias : structure.aliases)
        if (alias.is_pub && alias.module == module) names.push_back(alias.name);
    return names;
}

bool is_public(const Structure& structure, std::uint32_t module) {
    return std::ranges::any_of(structure.aliases,
                               [&](const Alias& alias) { return alias.is_pub && alias.module == module; });
}

Name name_in(const Program& program, const Structure& structure, std::uint32_t module) {
    enum Rank { own_public, own, imported, foreign };
    const auto rank_of = [&](const Alias& alias) {
        if (alias.module == module) return alias.is_pub ? own_public : own;
        return std::ranges::binary_search(program.modules[module].imports, alias.module) ? imported : foreign;
    };
    const auto best = std::ranges::min_element(structure.aliases, {}, rank_of);  // the first of several
    return best == structure.aliases.end() || rank_of(*best) == foreign ? Name{} : best->name;
}

}  // namespace gliftc::ir
