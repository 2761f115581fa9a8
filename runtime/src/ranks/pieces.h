// Which bytes ranks send each other.
#pragma once

#include "coverage.h"

#include <vector>

namespace glift::detail {

/// Bytes of a memory that one rank sends to another one.
struct Piece {
    unsigned from, to;
    Memory memory;
    const Paging* paging;  ///< null: the bytes lie together, from `offset` on
    std::uint64_t offset;  ///< with pages: of the run of bytes in each frame
    std::uint64_t run;     ///< bytes, of each page
    Planes planes = {};    ///< whose pages these are
    std::uint32_t frame_bytes = 0;

    std::uint64_t most_bytes() const { return paging ? run * paging->most_pages(planes) : run; }
    /// Where the host sees how many pages there are.
    std::uint64_t bytes() const { return paging ? run * paging->pages(planes).count() : run; }
};

/// Elements that each rank needs, up to `width` away from its own. `edges` says where addresses beyond the edge of a
/// dense structure lead.
std::vector<Piece> ghost_pieces(const Memory& memory, const Coverage& coverage, std::uint32_t width,
                                const SlabLayout& edges);
/// Planes of all owners, for all other ranks: of each owner those numbered [first, end) among its own.
std::vector<Piece> gather_pieces(const Memory& memory, const Coverage& coverage, Planes of_each);
/// What changes its owner with these cuts.
std::vector<Piece> migration_pieces(const Memory& memory, const Coverage& coverage, const Cuts& next);
/// The bytes of the plane that has most, where the host sees how many pages there are.
std::uint64_t most_bytes_of_plane(const Coverage& coverage);

}  // namespace glift::detail
