#include "ir/chain.h"

#include "ir/walk.h"

#include <algorithm>

namespace gliftc::ir {

const Structure& structure_at(const Program& program, const Structure& from, const RareVector<std::uint32_t>& members) {
    const Structure* structure = &from;
    for (std::uint32_t member : members) structure = &program.structures[structure->members[member].structure];
    return *structure;
}

Place base_of(const Structure& structure, const Place& place) {
    Place base = place;
    base.members.append(structure.base);
    return base;
}

/// Looks for the first two consecutive steps of the path such that one leads to a member that its owner makes, and the
/// next to a structure that this member's constructor was given. Returns the path with these steps replaced by the
/// owner's path to that structure; empty if there are no such steps.
static std::vector<std::uint32_t> with_giver(const Program& program, const Structure& from,
                                             const std::vector<std::uint32_t>& path) {
    const Structure* owner = &from;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const MemberStructure& member = owner->members[path[i]];
        const Structure& made = program.structures[member.structure];
        if (!member.by_reference && made.members[path[i + 1]].by_reference) {
            // Members by reference come first, in the order of the constructor's structure arguments.
            const Place& giver = member.structures[path[i + 1]];
            std::vector<std::uint32_t> result(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(i));
            result.insert(result.end(), giver.members.begin(), giver.members.end());
            result.insert(result.end(), path.begin() + static_cast<std::ptrdiff_t>(i) + 2, path.end());
            return result;
        }
        owner = &made;
    }
    return {};
}

std::vector<std::uint32_t> made_at(const Program& program, const Structure& from, std::vector<std::uint32_t> path) {
    for (auto next = with_giver(program, from, path); !next.empty(); next = with_giver(program, from, path))
        path = std::move(next);
    return path;
}

Place root_of(const Program& program, const Structure& structure, const Place& place) {
    Place root = place;
    const Structure* link = &structure;
    while (!link->base.empty()) {
        root = base_of(*link, root);
        link = &structure_at(program, *link, link->base);
    }
    return root;
}

const Structure& root_structure(const Program& program, const Structure& structure) {
    const Structure* link = &structure;
    while (!link->base.empty()) link = &structure_at(program, *link, link->base);
    return *link;
}

const Memory& root_memory(const Program& program, const Structure& structure) {
    const Structure& root = root_structure(program, structure);
    return root.memories[root.via_memory];
}

const Structure& whole_of(const Program& program, const Structure& structure) {
    const Structure* whole = &structure;
    while (whole->field) whole = &structure_at(program, *whole, whole->base);
    return *whole;
}

bool have_one_whole(const Program& program, const KernelParam& one, const KernelParam& other) {
    if (one.structure == other.structure || !one.structure || !other.structure) return false;
    return &whole_of(program, program.structures[one.structure]) ==
           &whole_of(program, program.structures[other.structure]);
}

/// The path from a structure to its whole (whole_of()).
static RareVector<std::uint32_t> path_to_whole(const Program& program, const Structure& structure) {
    RareVector<std::uint32_t> path;
    for (const Structure* at = &structure; at->field; at = &structure_at(program, *at, at->base)) path.append(at->base);
    return path;
}

std::optional<Place> seen_from(const Program& program, const Kernel& kernel, const Place& place, std::uint32_t to) {
    const auto whole_from = [&](std::uint32_t param) {
        return path_to_whole(program, program.structures[kernel.params[param].structure]);
    };
    const RareVector<std::uint32_t> from = whole_from(place.root);
    if (place.members.size() < from.size() || !std::equal(from.begin(), from.end(), place.members.begin()))
        return std::nullopt;
    Place seen{to, whole_from(to)};
    seen.members.append(place.members.begin() + from.size(), place.members.end());
    return seen;
}

std::vector<std::uint32_t> fields_in(const Program& program, const Structure& structure, const Structure& link) {
    std::vector<std::uint32_t> fields;
    for (const Structure* at = &structure; at != &link; at = &structure_at(program, *at, at->base))
        if (at->field) fields.insert(fields.begin(), *at->field);
    return fields;
}

std::optional<Place> blocks_of(const Program& program, const Structure& structure, const Place& place) {
    Place at = place;
    const Structure* link = &structure;
    while (!link->blocks) {
        if (!link->via.empty() || link->base.empty()) return std::nullopt;
        at = base_of(*link, at);
        link = &structure_at(program, *link, link->base);
    }
    return at;
}

namespace {

/// Collects the places, as paths from the structure `over`, whose elements functions read.
class ReadPlaces {
public:
    ReadPlaces(const Program& program, const Structure& over) : program_(program), over_(over) {}

    /// Adds the places that a function and its callees read. `at`: the places of the function's own structures
    /// (Function::structures).
    void add(FunctionId function, const std::vector<Place>& at);
    std::vector<Place> take() { return std::move(found_); }

private:
    void add(Place place);
    /// Adds what the translator of a stage of the structure at the place reads.
    void add_tables(const Stage& stage, const Place& at);

    const Program& program_;
    const Structure& over_;
    std::vector<Place> found_;
};

void ReadPlaces::add(Place place) {
    const Structure* link = &structure_at(program_, over_, place.members);
    Place at = place;
    while (true) {
        for (const Stage& stage : link->via) add_tables(stage, at);
        if (link->base.empty()) break;
        at = base_of(*link, at);
        link = &structure_at(program_, *link, link->base);
    }
    if (link->kind == StructureKind::computed) return add(link->at, {at});
    if (std::ranges::find(found_, place) == found_.end()) found_.push_back(std::move(place));
}

void ReadPlaces::add_tables(const Stage& stage, const Place& at) {
    std::vector<Place> tables;
    for (const Place& table : stage.structures) {
        tables.push_back(at);
        tables.back().members.append(table.members);
    }
    if (!tables.empty()) add(program_.translators[stage.translator].translate, tables);
}

void ReadPlaces::add(FunctionId function, const std::vector<Place>& at) {
    const auto resolved = [&](const Place& place) {
        Place whole = at[place.root];
        whole.members.append(place.members);
        return whole;
    };
    for_each_expression(program_, program_.functions[function].body, [&](ExprId id) {
        const Expr& node = program_.exprs[id];
        if (node.op == Op::read || node.op == Op::sample || node.op == Op::gather || node.op == Op::compare ||
            node.op == Op::translate)
            add(resolved(node.place));
        if (node.op != Op::call || node.places.empty()) return;
        std::vector<Place> handed;
        for (const Place& place : node.places) handed.push_back(resolved(place));
        add(node.function, handed);
    });
}

}  // namespace

std::vector<Place> places_of_blocks(const Program& program, const Structure& structure) {
    ReadPlaces places(program, structure);
    for (FunctionId function : {structure.blocks->count, structure.blocks->first}) places.add(function, {Place{}});
    return places.take();
}

const Blocks* visited_blocks(const Program& program, const Kernel& kernel) {
    if (!kernel.space) return nullptr;
    const Structure& structure = program.structures[kernel.params[*kernel.space].structure];
    const std::optional<Place> owner = blocks_of(program, structure, {});
    return owner ? &*structure_at(program, structure, owner->members).blocks : nullptr;
}

bool is_computed(const Program& program, const Structure& structure) {
    return root_structure(program, structure).kind == StructureKind::computed;
}

TypeId physical_type(const Program& program, const Structure& structure) {
    if (!structure.base.empty()) return structure_at(program, structure, structure.base).domain_type;
    if (structure.via.empty()) return {};
    return program.translators[structure.via.back().translator].physical_type;
}

bool translates_by_tables(const Program& program, const Structure& structure) {
    const auto has_tables = [](const Stage& stage) { return !stage.structures.empty(); };
    for (const Structure* link = &structure;; link = &structure_at(program, *link, link->base)) {
        if (std::ranges::any_of(link->via, has_tables)) return true;
        if (link->base.empty()) return false;
    }
}

bool is_total(const Program& program, const Structure& structure) {
    const Structure* link = &structure;
    while (link->via.empty() && !link->base.empty()) link = &structure_at(program, *link, link->base);
    return link->via.empty() || !program.translators[link->via[0].translator].properties.partial;
}

bool leads_through_partial(const Program& program, const Structure& structure) {
    for (const Structure* link = &structure; !link->base.empty();) {
        link = &structure_at(program, *link, link->base);
        if (!is_total(program, *link)) return true;
    }
    return false;
}

bool may_be_sparse(const Program& program, const Structure& structure) {
    const auto is_sparse = [&](const Stage& stage) {
        const Properties& properties = program.translators[stage.translator].properties;
        return properties.partial || properties.mapping != Mapping::claimed_one_to_one;
    };
    for (const Structure* link = &structure;; link = &structure_at(program, *link, link->base)) {
        if (std::ranges::any_of(link->via, is_sparse)) return true;
        if (link->base.empty()) return false;
    }
}

bool has_resident_part(const Program& program, const Structure& structure) {
    return structure.kind == StructureKind::stored && !is_computed(program, structure) &&
           (may_be_sparse(program, structure) || blocks_of(program, structure, {}));
}

RareVector<std::uint32_t> translated_by(const Program& program, const Structure& structure) {
    RareVector<std::uint32_t> path;
    for (const Structure* link = &structure; link->via.empty() && !link->base.empty();
         link = &structure_at(program, *link, link->base))
        path.append(link->base);
    return path;
}

bool is_contained(const Program& program, const Structure& structure) {
    const TypeId type = physical_type(program, structure);
    return type && structure.contained_axes == (1u << program.types.components(type)) - 1;
}

bool stays_inside(const Program& program, const Structure& structure) {
    return structure.base.empty() && !structure.otherwise && !structure.via.empty() &&
           !program.translators[structure.via.back().translator].properties.partial;
}

bool takes_commands(const Program& program, const Structure& structure) {
    if (structure.field) return false;
    return structure.kind != StructureKind::computed || structure.is_container ||
           std::ranges::any_of(structure.members, [&](const MemberStructure& member) {
               return !member.by_reference && takes_commands(program, program.structures[member.structure]);
           });
}

std::optional<Place> says_otherwise(const Program& program, const Structure& structure, const Place& place) {
    Place at = place;
    const Structure* link = &structure;
    while (!link->otherwise) {
        if (link->base.empty()) return std::nullopt;
        at = base_of(*link, at);
        link = &structure_at(program, *link, link->base);
    }
    return at;
}

}  // namespace gliftc::ir
