// Where the elements of the library's sparse structures lie in a file.
#pragma once

#include "content.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace gliftinfo {

/// The pages of a sparse grid of three axes.
struct SparseGrid {
    std::array<std::uint32_t, 3> page{};    ///< elements along each axis
    std::array<std::uint64_t, 3> extent{};  ///< of the grid, in elements
    /// The first address of the page in each frame; none: the frame is free.
    std::vector<std::optional<std::array<std::uint64_t, 3>>> origins;
    double background = 0;
};

/// The grid whose frames are at a path; none: it is no memory of frames. Knows std.sparse, with either allocation, and
/// std.sparse_hashed. Throws wrong_argument for page tables that it does not know.
std::optional<SparseGrid> sparse_grid_at(glift::files::VerifiedFile& file, const glift::files::FiledPart& structure,
                                         const Content& frames);

}  // namespace gliftinfo
