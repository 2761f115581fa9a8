#include "diffusion.h"

#include <oneapi/tbb/blocked_range2d.h>
#include <oneapi/tbb/parallel_for.h>

#include <cstddef>

namespace handwritten {

namespace {

/// Pointers to a row of the source, to its four neighbour rows and to the row to write. A neighbour beyond the border
/// is the row itself.
struct Rows {
    const float *centre, *above, *below, *behind, *before;
    float* target;
};

inline float diffused(const Rows& rows, std::size_t x, float right, float left, float rate) {
    const float centre = rows.centre[x];
    float flow = -6.0f * centre;
    flow += right + left;
    flow += rows.above[x] + rows.below[x];
    flow += rows.behind[x] + rows.before[x];
    return centre + rate * flow;
}

inline void diffuse_elements(const Rows& rows, std::size_t count, float rate) {
    const float* const u = rows.centre;
    rows.target[0] = diffused(rows, 0, u[count > 1], u[0], rate);
#pragma GCC ivdep
    for (std::size_t x = 1; x < count - 1; ++x) rows.target[x] = diffused(rows, x, u[x + 1], u[x - 1], rate);
    rows.target[count - 1] = diffused(rows, count - 1, u[count - 1], u[count - 1 - (count > 1)], rate);
}

// Function multiversioning, as in the generated code.
__attribute__((target_clones("default", "avx2", "avx512f"))) void diffuse_row(const Rows& rows, std::size_t count,
                                                                              float rate) {
    diffuse_elements(rows, count, rate);
}

void diffuse_row_narrow(const Rows& rows, std::size_t count, float rate) { diffuse_elements(rows, count, rate); }

template <class Row> void on_all_rows(const float* u, float* v, Extent3 extent, float rate, const Row& diffuse_one) {
    const std::size_t row = extent.x, plane = row * extent.y;
    const auto run = [=](const tbb::blocked_range2d<std::uint32_t>& range) {
        for (std::uint32_t z = range.rows().begin(); z < range.rows().end(); ++z) {
            for (std::uint32_t y = range.cols().begin(); y < range.cols().end(); ++y) {
                const float* centre = u + z * plane + y * row;
                const Rows rows = {centre,
                                   centre + (y + 1 < extent.y ? row : 0),
                                   centre - (y > 0 ? row : 0),
                                   centre + (z + 1 < extent.z ? plane : 0),
                                   centre - (z > 0 ? plane : 0),
                                   v + z * plane + y * row};
                diffuse_one(rows, extent.x, rate);
            }
        }
    };
    tbb::parallel_for(tbb::blocked_range2d<std::uint32_t>(0, extent.z, 0, extent.y), run);
}

}  // namespace

void diffuse(const float* u, float* v, Extent3 extent, float rate) { on_all_rows(u, v, extent, rate, diffuse_row); }

void diffuse_narrow(const float* u, float* v, Extent3 extent, float rate) {
    on_all_rows(u, v, extent, rate, diffuse_row_narrow);
}

}  // namespace handwritten
