// The software rasteriser of the host device: generated code describes a draw, shades its vertices, and shades
// fragments block by block.
//
// Coverage is that of Vulkan with 8 bits of subpixel precision: window coordinates are rounded to 1/256 of a pixel, a
// pixel is covered if its centre lies inside a triangle or on a top or left edge. A line is a rectangle one pixel wide
// (Vulkan's strict lines), a point a square of one pixel; both are drawn as two triangles, which are front-facing.
// Vertices are drawn in batches, one after the other. In each, chunks of vertices are shaded in parallel, then tiles of
// the viewport are drawn in parallel; within a tile, triangles keep their order.
#pragma once

#include <glift/api.h>
#include <glift/drawing.h>
#include <glift/vector.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace glift::host {

/// The depth target: 32-bit floats, row by row, beginning with the viewport's first pixel.
struct DepthTarget {
    float* texels = nullptr;  ///< null: no depth target
    std::size_t row = 0;      ///< texels from one row to the next
    DepthTest test = DepthTest::less;
    bool is_written = true;
    /// Whether depth is tested before the fragment shader runs. If not, the fragment shader calls Fragments::test, or
    /// test_depth (fragments.h) with depths of its own.
    bool is_early = true;
};

/// The fragments of one triangle in a block of 8 x 8 pixels: pixel (x, y) of the block is entry 8 * y + x of each
/// array. Entries are set for all pixels of the quads that have a covered one, so that derivatives can be computed from
/// neighbours; others hold any number.
struct Fragments {
    static constexpr unsigned side = 8;

    /// The block's first pixel, relative to the viewport's. Blocks begin at even pixels of the framebuffer, as quads do
    /// on a GPU: where the viewport begins at an odd one, this may be -1.
    int2 first;
    std::uint64_t covered;  ///< bit i: pixel i is covered and did not fail an early depth test
    bool is_front;
    const float* corner[3];  ///< varyings of the triangle's vertices, which clipping may have made
    const float* flat;       ///< varyings of the first vertex of the draw's triangle, line or point
    const DepthTarget* depth_target;
    alignas(64) float depth[side * side];
    /// Barycentric weights of vertices 1 and 2 in the window, for `linear` varyings; the weight of vertex 0 is 1 minus
    /// both.
    alignas(64) float linear1[side * side], linear2[side * side];
    /// The perspective-correct weights of vertices 1 and 2, for `smooth` varyings. These and `w` are set only if
    /// Draw::has_smooth.
    alignas(64) float smooth1[side * side], smooth2[side * side];
    alignas(64) float w[side * side];  ///< 1 / w, as gl_FragCoord.w

    /// The late depth test: tests depths, and stores those that pass if DepthTarget::is_written. Returns those of
    /// `pixels` that pass, all of them if there is no depth target or the test was early.
    GLIFT_API std::uint64_t test(std::uint64_t pixels) const;
};

/// One draw. The vertex shader writes for each vertex x, y, z, w in clip coordinates, then clip distances, then
/// varyings.
struct Draw {
    const void* body = nullptr;  ///< passed to both shaders
    void (*vertex)(const void* body, std::uint64_t first, std::uint32_t count, std::uint32_t instance,
                   float* corners) = nullptr;
    /// Null: the draw has no fragment shader, and only depth is written.
    void (*fragment)(const void* body, const Fragments& fragments) = nullptr;

    Topology topology = Topology::triangles;
    std::uint64_t corners = 0;  ///< number of vertices; an incomplete triangle or line at the end is not drawn
    std::uint32_t instances = 1;
    std::uint32_t clip_distances = 0, varyings = 0;  ///< floats of a vertex after its position
    uint2 viewport;                                  ///< size, at most 16384 along each axis
    uint2 framebuffer;                               ///< the viewport's first pixel in the framebuffer
    Cull cull = Cull::none;
    bool has_smooth = false;  ///< whether the fragment shader may use smooth weights or w
    DepthTarget depth;
};

/// Runs a draw, on all cores. The vertex shader runs once per vertex and instance. Needs memory for one batch: at most
/// 98,304 vertices, and their triangles.
GLIFT_API void draw(const Draw& draw);

}  // namespace glift::host
