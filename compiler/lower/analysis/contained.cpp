#include "lower/analysis/contained.h"

#include "ir/chain.h"
#include "lower/analysis/bounds.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;
using symbolic::number;
using symbolic::operator-;
using symbolic::Sum;

namespace {

/// Component `lane` of constructor argument `slot`.
struct Argument {
    std::uint32_t slot, lane;
};

/// The constructor arguments' components that are the extents of the domain, one per axis; empty if the domain is
/// anything else.
std::vector<Argument> extents_of(const Program& p, StructureId index) {
    const Structure& s = p.structures[index];
    BoundsInterpreter following(p, index);
    const Parts domain = following.of_structure(s.domain);
    std::vector<Argument> extents;
    for (const Part& part : domain) {
        for (std::uint32_t slot = 0; slot < s.constructor.size(); ++slot) {
            const Parts argument = following.member(slot, p.locals[s.constructor[slot]].type);
            for (std::uint32_t lane = 0; lane < argument.size(); ++lane)
                if (argument[lane].sum == part.sum) extents.push_back({slot, lane});
        }
    }
    return extents.size() == domain.size() ? extents : std::vector<Argument>{};
}

bool is_partial(const Program& p, const Structure& s) { return !is_total(p, s); }

/// A symbolic address that stands for all that may be translated: any address if the first translator is partial, else
/// one of the domain.
Parts any_address(BoundsInterpreter& following, const Program& p, const Structure& s) {
    const Parts domain = following.of_structure(s.domain);
    Parts address;
    for (const Part& part : domain) {
        std::optional<Sum> high;
        if (!is_partial(p, s)) high = part.sum - number(1);
        address.push_back({following.symbols.varying({number(0), high}), {}});
    }
    return address;
}

constexpr std::uint8_t all_axes = 0xff;

/// The axes (a bit for each) along which every physical address lies in the memory, provided that the domain is not
/// empty.
std::uint8_t axes_inside(const Program& p, StructureId index, const std::vector<Argument>& extents) {
    const Structure& s = p.structures[index];
    BoundsInterpreter following(p, index);
    for (const Argument& each : extents) following.set_member(each.slot, each.lane, following.symbols.size(1));
    const std::optional<Parts> at = following.translated(any_address(following, p, s));
    if (!at) return all_axes;
    const Parts memory = following.extent_of_memory();
    std::uint8_t axes = 0;
    for (std::size_t i = 0; i < memory.size() && memory.size() == at->size(); ++i)
        if (following.symbols.is_natural(memory[i].sum - (*at)[i].sum - number(1))) axes |= 1u << i;
    return axes;
}

/// Whether accesses need no check even if the constructor argument `none`, an extent of the domain, is 0: every address
/// is unmapped, or leads to physical address 0 of a buffer or image. Buffers and images always have room for one
/// element, which reads as zero (so there must be no `otherwise`); a memory that is a structure may have no elements.
bool is_harmless_empty(const Program& p, StructureId index, const Argument& none) {
    const Structure& s = p.structures[index];
    BoundsInterpreter following(p, index);
    following.set_member(none.slot, none.lane, number(0));
    const std::optional<Parts> at = following.translated(any_address(following, p, s));
    if (!at) return true;
    return !s.otherwise && s.base.empty() && std::ranges::all_of(*at, [&](const Part& part) {
        return following.symbols.is_natural(number(0) - part.sum);
    });
}

bool has_memory(const Structure& s) { return !s.base.empty() || !s.memories.empty(); }

/// Whether the structure has no translator, and its domain is that of the structure that is its memory.
bool has_domain_of_base(const Program& p, const Structure& s) {
    if (!s.via.empty() || s.base.empty()) return false;
    const Expr& domain = p.exprs[s.domain];
    return domain.op == Op::domain && domain.place.members == s.base;
}

std::uint8_t contained_axes(const Program& p, StructureId index) {
    const Structure& s = p.structures[index];
    if (!has_memory(s) || !s.domain) return 0;
    if (has_domain_of_base(p, s)) return all_axes;
    const std::vector<Argument> extents = extents_of(p, index);
    const std::uint8_t axes = axes_inside(p, index, extents);
    // If the first translator is total, only addresses in the domain are accessed: none if the domain is empty.
    if (axes == 0 || !is_partial(p, s)) return axes;
    const bool is_harmless = !extents.empty() && std::ranges::all_of(extents, [&](const Argument& each) {
        return is_harmless_empty(p, index, each);
    });
    return is_harmless ? axes : 0;
}

}  // namespace

void mark_contained(Program& program) {
    for (StructureId i : program.structures.ids()) {
        Structure& s = program.structures[i];
        const TypeId type = physical_type(program, s);
        const std::uint32_t axes = type ? program.types.components(type) : 0;
        s.contained_axes = static_cast<std::uint8_t>(contained_axes(program, i) & ((1u << axes) - 1));
    }
}

}  // namespace gliftc::lower
