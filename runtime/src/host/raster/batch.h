// A batch of up to 98,304 vertices of a draw: chunks of them are turned into triangles in parallel, and the triangles
// are sorted into the tiles of the viewport that they may touch; then the tiles are drawn in parallel.
#pragma once

#include "host/raster/clip.h"

#include <span>
#include <vector>

namespace glift::host::raster {

/// The tiles of a viewport: at most 1024 squares, whose sides are multiples of a block's.
struct Tiles {
    std::int32_t side;
    std::uint32_t across, down;
    std::uint32_t count() const { return across * down; }
};
Tiles tiles_of(uint2 size);

/// The number of vertices of a primitive.
std::uint32_t corners_of(Topology topology);

/// Consecutive triangles of the draw, and for each tile those that may touch it, in the order of the draw.
class Chunk {
public:
    /// Runs the vertex shader for `count` vertices from `first` on, and sets up the triangles of their primitives:
    /// clipping turns a triangle into none, one or several; a line or a point becomes up to two.
    void make(const Draw& draw, const Window& window, const Clipper& clipper, const Tiles& tiles, std::uint64_t first,
              std::uint32_t count, std::uint32_t instance);
    const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Indices of the triangles that may touch a tile.
    std::span<const std::uint32_t> in_tile(std::uint32_t tile) const {
        return {sorted_.data() + begins_[tile], sorted_.data() + begins_[tile + 1]};
    }

private:
    void add(const Window& window, const Polygon& polygon);
    void add_others(Topology topology, const Window& window, const Clipper& clipper, std::uint32_t count);
    void add_triangles(const Window& window, const Clipper& clipper, std::uint32_t count);
    void add(const Window& window, const Corner& corner0, const Corner& corner1, const Corner& corner2);
    void add_line(const Window& window, const Clipper& clipper, const float* from, const float* to);
    void add_point(const Window& window, const Clipper& clipper, const float* vertex);
    void sort(const Tiles& tiles);

    std::vector<float> vertices_;
    std::vector<Corner> corners_;  ///< the vertices of triangles before clipping, in the window
    MadeCorners made_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> begins_, sorted_;
};

/// Draws the chunks' triangles in one tile, one chunk after the other.
void draw_tile(const Draw& draw, std::span<const Chunk> chunks, const Tiles& tiles, std::uint32_t tile);

}  // namespace glift::host::raster
