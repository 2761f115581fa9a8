// The memory of a structure may be another structure, and so on: a chain, whose links are structures. Its last link,
// the root, has the buffer or image that holds the elements, or is a view, which computes them.
#pragma once

#include "ir/ir.h"

namespace gliftc::ir {

/// The structure that a path of members leads to, from the structure `from`.
const Structure& structure_at(const Program& program, const Structure& from, const RareVector<std::uint32_t>& members);

/// Another path to the structure that `path` leads to from `from`. Where `path` goes through a member to a structure
/// that this member's constructor was given, the result goes to that structure by the path that the member's owner has
/// to it. All paths from `from` to one structure so become equal, unless `from` itself was given that structure more
/// than once: directly, or as a member of another structure that it was given.
std::vector<std::uint32_t> made_at(const Program& program, const Structure& from, std::vector<std::uint32_t> path);

/// The place of the structure that is the memory of `structure` (the next link), which is at `place`. Only if
/// Structure::base is not empty.
Place base_of(const Structure& structure, const Place& place);

/// The place of the root of `structure`, which is at `place`; and the root itself.
Place root_of(const Program& program, const Structure& structure, const Place& place);
const Structure& root_structure(const Program& program, const Structure& structure);

/// The buffer or image of the root. Only for structures whose root is not a view: is_computed() is false.
const Memory& root_memory(const Program& program, const Structure& structure);

/// The structure that the structure is a component of, or a component of such a component; the structure itself if it
/// is none.
const Structure& whole_of(const Program& program, const Structure& structure);

/// Whether one of two parameters has a component of the structure that the other has, or of which the other has another
/// component.
bool have_one_whole(const Program& program, const KernelParam& one, const KernelParam& other);

/// Of parameters that have_one_whole(): a place that begins at one of them, within the whole, as a path from the
/// parameter `to`. Absent: it is not within the whole.
std::optional<Place> seen_from(const Program& program, const Kernel& kernel, const Place& place, std::uint32_t to);

/// The fields by which the elements of `structure` lie in those of `link`, one of the structures of its chain,
/// outermost first: of components (Structure::field). Empty: they are those elements.
std::vector<std::uint32_t> fields_in(const Program& program, const Structure& structure, const Structure& link);

/// The place of the first link that declares blocks, in the chain of `structure`, which is at `place`; only if no link
/// before it has a `via`: addresses are then the same. Absent: the whole domain is one block.
std::optional<Place> blocks_of(const Program& program, const Structure& structure, const Place& place);

/// What the functions `count` and `first` of the structure's own blocks depend on: the places (root 0 is `structure`)
/// of all structures with memory that these functions and their callees read or translate by, and of the tables that
/// those translators read. In place of a view, what its `at` reads.
std::vector<Place> places_of_blocks(const Program& program, const Structure& structure);

/// The blocks that a kernel visits; null: it visits whole ranges.
const Blocks* visited_blocks(const Program& program, const Kernel& kernel);

/// Whether the root of the chain is a view, so that elements are computed and not loaded.
bool is_computed(const Program& program, const Structure& structure);

/// The type of the structure's physical addresses; none if it has neither a translator nor a structure as its memory.
TypeId physical_type(const Program& program, const Structure& structure);

/// Whether a translator of some link takes structures as its state, such as a page table.
bool translates_by_tables(const Program& program, const Structure& structure);

/// Whether the first translator of the chain is total (it never gives `none`), or the chain has no translator.
bool is_total(const Program& program, const Structure& structure);

/// Whether some link after the first is not total (is_total()), so that its translator decides itself which addresses
/// are mapped.
bool leads_through_partial(const Program& program, const Structure& structure);

/// Whether an address may have no element, or several addresses may have the same element: some translator of the chain
/// is partial, or is neither declared one-to-one nor has `invert`. That addresses may lead outside the memory (see
/// is_contained()) does not count.
bool may_be_sparse(const Program& program, const Structure& structure);

/// Whether a structure stores elements and has blocks or may be sparse (may_be_sparse()). Programs can then list the
/// elements that are there.
bool has_resident_part(const Program& program, const Structure& structure);

/// The first structure of the chain that has a translator, else its root, as a path of members.
RareVector<std::uint32_t> translated_by(const Program& program, const Structure& structure);

/// Whether it is proved that no address of the domain leads outside the structure's memory along any axis
/// (Structure::contained_axes). False if there is no physical_type().
bool is_contained(const Program& program, const Structure& structure);

/// Whether a physical address outside of the memory is a mistake: the last translator is total. Not if the memory is a
/// structure, in which such an address is unmapped, or if the structure says `otherwise`, by which elements are meant
/// to be missing.
bool stays_inside(const Program& program, const Structure& structure);

/// Whether the structure is made for a device: it is a container, or may allocate memory. False for components, and for
/// other views all of whose members are given to them, or are themselves views for which it is false.
bool takes_commands(const Program& program, const Structure& structure);

/// The place of the first link with an `otherwise`, the value of reads at unmapped addresses; absent: none has one.
std::optional<Place> says_otherwise(const Program& program, const Structure& structure, const Place& place);

}  // namespace gliftc::ir
