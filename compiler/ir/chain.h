// Memory that is a structure: the chain of structures from one that is accessed to the one whose memory holds the
// elements, its root.
#pragma once

#include "ir/ir.h"

namespace gliftc::ir {

/// What a path of members leads to, from a structure.
const Structure& structure_at(const Program& program, const Structure& from, const RareVector<std::uint32_t>& members);

/// The memory of the structure at a place, where that is a structure.
Place base_of(const Structure& structure, const Place& place);

/// The root of the structure at a place.
Place root_of(const Program& program, const Structure& structure, const Place& place);
const Structure& root_structure(const Program& program, const Structure& structure);

/// The memory of the root. Only of structures that have one: is_computed() is false.
const Memory& root_memory(const Program& program, const Structure& structure);

/// Where the structure's blocks are declared: by itself, or by its memory, where its addresses are the memory's.
/// Absent: the whole domain is one block.
std::optional<Place> blocks_of(const Program& program, const Structure& structure, const Place& place);

/// What the functions of blocks read: places over the structure that declares them.
std::vector<Place> places_of_blocks(const Program& program, const Blocks& blocks);

/// The blocks that a kernel visits; null: whole ranges.
const Blocks* visited_blocks(const Program& program, const Kernel& kernel);

/// Whether the elements are computed: those of a view, and of what has a view as memory.
bool is_computed(const Program& program, const Structure& structure);

/// The address type of the structure's own memory; none where it has no memory.
TypeId physical_type(const Program& program, const Structure& structure);

/// Whether some link of the chain translates by reading structures.
bool translates_by_tables(const Program& program, const Structure& structure);

/// Whether the first translator of the chain maps every address of its domain.
bool is_total(const Program& program, const Structure& structure);

/// Whether some memory of the chain is a structure that maps addresses beyond its domain as it likes.
bool leads_through_partial(const Program& program, const Structure& structure);

/// Whether several addresses of the chain's domain may have one element, or none: as far as is known.
bool may_be_sparse(const Program& program, const Structure& structure);

/// Whether programs can list the elements of a structure that are there: they need not be those of the whole domain.
bool has_resident_part(const Program& program, const Structure& structure);

/// The first structure of the chain that has a translator, else its root, as a path of members.
RareVector<std::uint32_t> translated_by(const Program& program, const Structure& structure);

/// Whether no address leads beyond the structure's own memory, along all of its axes.
bool is_contained(const Program& program, const Structure& structure);

/// Whether memory is made where the structure is.
bool makes_memory(const Program& program, const Structure& structure);

/// The first structure of the chain that says what lies outside, as a place; absent: none does.
std::optional<Place> says_otherwise(const Program& program, const Structure& structure, const Place& place);

}  // namespace gliftc::ir
