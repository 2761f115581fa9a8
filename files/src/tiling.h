// How a grid of elements is cut into chunks. A chunk is a run of elements in row-major order: some rows of one axis,
// whole along all later axes.
#pragma once

#include <cstdint>
#include <vector>

namespace glift::files {

/// Some elements of a grid. Lists begin with the slowest axis.
struct Batch {
    std::uint64_t first = 0, count = 0;  ///< in row-major order
    std::vector<std::uint64_t> origin, size;
};

struct Tiling {
    std::vector<std::uint64_t> shape;
    std::size_t axis = 0;      ///< the axis that is cut
    std::uint64_t length = 1;  ///< of a chunk along that axis

    /// Chunks with at most `most` elements, as whole as possible. Axes before `first_axis` are cut into single steps.
    static Tiling of(std::vector<std::uint64_t> shape, std::uint64_t most, std::size_t first_axis = 0);

    std::uint64_t elements() const;
    std::vector<std::uint64_t> chunk() const;
    std::uint64_t chunk_elements() const;
    /// All chunks, in row-major order.
    std::uint64_t count() const;
    Batch batch(std::uint64_t number) const;
};

}  // namespace glift::files
