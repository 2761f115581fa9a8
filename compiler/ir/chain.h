// The memory of a structure may be another structure, and so on: a chain, whose links are structures. Its last link,
// the root, has the buffer or image that holds the elements, or is a view, which computes them.
#pragma once

#include "ir/ir.h"

namespace gliftc::ir {

/// The structure that a path of members leads to, from the structure `from`.
const Structure& structure_at(const Program& program, const Structure& from, const RareVector<std::uint32_t>& members);

/// The same structure's path through members that are made by their owners: where a member was given to its owner by
/// the maker of the owner, the path to what that maker gave. One structure has one such path from `from`, but for
/// structures that `from` itself was given twice.
std::vector<std::uint32_t> made_at(const Program& program, const Structure& from, std::vector<std::uint32_t> path);

/// The place of the next link: the structure that is the memory of `structure`, which is at `place`.
Place base_of(const Structure& structure, const Place& place);

/// The place of the root of `structure`, which is at `place`; and the root itself.
Place root_of(const Program& program, const Structure& structure, const Place& place);
const Structure& root_structure(const Program& program, const Structure& structure);

/// The buffer or image of the root. Only for structures whose root is not a view: is_computed() is false.
const Memory& root_memory(const Program& program, const Structure& structure);

/// The link that declares the structure's blocks: the structure itself, or further links as long as there is no `via`
/// in between, so that addresses stay the same. Absent: the whole domain is one block.
std::optional<Place> blocks_of(const Program& program, const Structure& structure, const Place& place);

/// The structures with memory whose elements the functions `count` and `first` of a structure's own blocks read, also
/// those that views among them read: places over the structure.
std::vector<Place> places_of_blocks(const Program& program, const Structure& structure);

/// The blocks that a kernel visits; null: it visits whole ranges.
const Blocks* visited_blocks(const Program& program, const Kernel& kernel);

/// Whether the root of the chain is a view, so that elements are computed and not loaded.
bool is_computed(const Program& program, const Structure& structure);

/// The type of the structure's physical addresses; none if it has neither a translator nor a structure as its memory.
TypeId physical_type(const Program& program, const Structure& structure);

/// Whether a translator of some link reads structures, such as a page table.
bool translates_by_tables(const Program& program, const Structure& structure);

/// Whether the first translator of the chain is total (not partial: it never gives `none`), or there is none.
bool is_total(const Program& program, const Structure& structure);

/// Whether a link after the first begins with a partial translator, which decides itself what lies beyond its domain.
bool leads_through_partial(const Program& program, const Structure& structure);

/// Whether, as far as is known, an address may have no element, or several addresses the same one: some translator is
/// partial or not known to be one-to-one.
bool may_be_sparse(const Program& program, const Structure& structure);

/// Whether a structure stores elements, but perhaps not one for every address of its domain, so that programs can list
/// which are there: it has blocks, or may be sparse.
bool has_resident_part(const Program& program, const Structure& structure);

/// The first structure of the chain that has a translator, else its root, as a path of members.
RareVector<std::uint32_t> translated_by(const Program& program, const Structure& structure);

/// Whether it is proved that no address leads beyond the structure's own memory, along any of its axes.
bool is_contained(const Program& program, const Structure& structure);

/// Whether making the structure allocates memory: false for views that make no members, or only such views.
bool makes_memory(const Program& program, const Structure& structure);

/// The place of the first link with an `otherwise`, the value of reads at unmapped addresses; absent: none has one.
std::optional<Place> says_otherwise(const Program& program, const Structure& structure, const Place& place);

}  // namespace gliftc::ir
