#include "host/raster/batch.h"

#include "host/raster/block.h"

#include <algorithm>
#include <cmath>

namespace glift::host::raster {

namespace {

constexpr std::uint32_t max_tiles = 1024;
constexpr std::int32_t smallest_tile = 64;

/// A box of tiles or blocks; `right` and `bottom` are exclusive.
struct Box {
    std::int32_t left, top, right, bottom;
};

/// The squares of the given side that a triangle's bounding box touches.
Box squares_of(const Triangle& triangle, std::int32_t side) {
    return {triangle.left / side, triangle.top / side, (triangle.right - 1) / side + 1,
            (triangle.bottom - 1) / side + 1};
}

Box common(const Box& a, const Box& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

template <class Body> void for_each(const Box& box, Body&& body) {
    for (std::int32_t y = box.top; y < box.bottom; ++y)
        for (std::int32_t x = box.left; x < box.right; ++x) body(x, y);
}

struct BlockDraw {
    const Draw& draw;
    int2 viewport;  ///< the viewport's first pixel, in the coordinates of blocks
    Fragments fragments;

    explicit BlockDraw(const Draw& draw) : draw(draw), viewport(int2(draw.framebuffer % 2u)), fragments() {
        fragments.depth_target = &draw.depth;
    }

    void run(const Triangle& triangle, std::int32_t x, std::int32_t y) {
        std::uint64_t covered = coverage(triangle, x, y);
        if (covered == 0) return;
        const Rows rows = rows_of(covered);
        interpolate_depth(triangle, x, y, rows, fragments);
        fragments.first = int2(x, y) - viewport;
        if (draw.depth.texels != nullptr && draw.depth.is_early)
            covered = test_depth(draw.depth, fragments.first, fragments.depth, covered);
        if (covered == 0 || draw.fragment == nullptr) return;
        if (draw.has_smooth) interpolate_smooth(triangle, rows, fragments);
        fragments.covered = covered;
        fragments.is_front = triangle.is_front;
        fragments.flat = triangle.flat;
        std::copy(std::begin(triangle.corner), std::end(triangle.corner), std::begin(fragments.corner));
        draw.fragment(draw.body, fragments);
    }
};

}  // namespace

std::uint32_t corners_of(Topology topology) {
    switch (topology) {
    case Topology::triangles: return 3;
    case Topology::lines: return 2;
    case Topology::points: return 1;
    }
    return 3;
}

Tiles tiles_of(uint2 size) {
    Tiles tiles{smallest_tile, 0, 0};
    const auto count_along = [&](uint n) {
        return (n + static_cast<uint>(tiles.side) - 1) / static_cast<uint>(tiles.side);
    };
    while (count_along(size.x) * count_along(size.y) > max_tiles) tiles.side *= 2;
    tiles.across = count_along(size.x);
    tiles.down = count_along(size.y);
    return tiles;
}

void Chunk::make(const Draw& draw, const Window& window, const Clipper& clipper, const Tiles& tiles,
                 std::uint64_t first, std::uint32_t count, std::uint32_t instance) {
    const std::uint32_t stride = window.layout.stride();
    vertices_.resize(std::size_t{count} * stride);
    made_.clear();
    triangles_.clear();
    draw.vertex(draw.body, first, count, instance, vertices_.data());
    if (draw.topology == Topology::triangles) add_triangles(window, clipper, count);
    else add_others(draw.topology, window, clipper, count);
    sort(tiles);
}

void Chunk::add_triangles(const Window& window, const Clipper& clipper, std::uint32_t count) {
    const std::size_t stride = window.layout.stride();
    corners_.resize(count);
    corners_of(window, vertices_.data(), count, corners_.data());
    for (std::uint32_t i = 0; i + 3 <= count; i += 3) {
        const float* vertex = vertices_.data() + i * stride;
        const std::size_t before = triangles_.size();
        if (clipper.is_inside(vertex) && clipper.is_inside(vertex + stride) && clipper.is_inside(vertex + 2 * stride))
            add(window, corners_[i], corners_[i + 1], corners_[i + 2]);
        else add(window, clipper.clipped(vertex, vertex + stride, vertex + 2 * stride, made_));
        for (std::size_t k = before; k < triangles_.size(); ++k)
            triangles_[k].flat = vertex + window.layout.varyings_at();
    }
}

/// The triangles that lines and points become are front-facing, whatever their orientation.
void Chunk::add_others(Topology topology, const Window& window, const Clipper& clipper, std::uint32_t count) {
    const std::size_t stride = window.layout.stride();
    const std::uint32_t step = corners_of(topology);
    for (std::uint32_t i = 0; i + step <= count; i += step) {
        const float* vertex = vertices_.data() + i * stride;
        const std::size_t before = triangles_.size();
        if (topology == Topology::lines) add_line(window, clipper, vertex, vertex + stride);
        else add_point(window, clipper, vertex);
        for (std::size_t k = before; k < triangles_.size(); ++k) {
            triangles_[k].flat = vertex + window.layout.varyings_at();
            triangles_[k].is_front = true;
        }
    }
}

void Chunk::add(const Window& window, const Corner& corner0, const Corner& corner1, const Corner& corner2) {
    if (auto triangle = triangle_of(window, corner0, corner1, corner2)) triangles_.push_back(*triangle);
}

/// A rectangle around the line, half a pixel to both sides. The offset is rounded to 1/256 of a pixel, as vertices are;
/// llvmpipe does the same.
void Chunk::add_line(const Window& window, const Clipper& clipper, const float* from, const float* to) {
    if (!clipper.clip_line(from, to, made_)) return;
    const float2 begin = place_of(window, from), end = place_of(window, to), way = end - begin;
    const Corner a = corner_of(window, from), b = corner_of(window, to);
    const float length = std::sqrt(way.x * way.x + way.y * way.y);
    if (!(length > 0.0f)) return;
    const float scale = 0.5f / length;
    const auto rounded = [](float x) {
        return static_cast<std::int32_t>(std::llrint(static_cast<double>(x) * (1 << subpixel_bits)));
    };
    const Point aside{rounded(-way.y * scale), rounded(way.x * scale)};
    const auto beside = [](const Corner& corner, const Point& by, int sign) {
        return Corner{{corner.point.x + sign * by.x, corner.point.y + sign * by.y}, corner.inverse_w, corner.vertex};
    };
    add(window, beside(a, aside, -1), beside(b, aside, -1), beside(b, aside, 1));
    add(window, beside(a, aside, -1), beside(b, aside, 1), beside(a, aside, 1));
}

/// A square around the point, half a pixel to each side.
void Chunk::add_point(const Window& window, const Clipper& clipper, const float* vertex) {
    if (!clipper.is_inside(vertex)) return;
    constexpr std::int32_t half = 1 << (subpixel_bits - 1);
    const Corner middle = corner_of(window, vertex);
    const auto at = [&](std::int32_t x, std::int32_t y) {
        return Corner{{middle.point.x + x, middle.point.y + y}, middle.inverse_w, vertex};
    };
    add(window, at(-half, -half), at(half, -half), at(half, half));
    add(window, at(-half, -half), at(half, half), at(-half, half));
}

/// Splits a polygon into a fan around its first vertex.
void Chunk::add(const Window& window, const Polygon& polygon) {
    for (unsigned i = 2; i < polygon.count; ++i)
        add(window, corner_of(window, polygon.corners[0]), corner_of(window, polygon.corners[i - 1]),
            corner_of(window, polygon.corners[i]));
}

/// A counting sort: the number of triangles of each tile, prefix sums, then the triangles' indices.
void Chunk::sort(const Tiles& tiles) {
    begins_.assign(tiles.count() + 1, 0);
    const auto for_each_tile = [&](const Triangle& triangle, auto&& body) {
        for_each(squares_of(triangle, tiles.side), [&](std::int32_t x, std::int32_t y) {
            body(static_cast<std::uint32_t>(y) * tiles.across + static_cast<std::uint32_t>(x));
        });
    };
    for (const Triangle& triangle : triangles_)
        for_each_tile(triangle, [&](std::uint32_t tile) { ++begins_[tile + 1]; });
    for (std::uint32_t tile = 0; tile < tiles.count(); ++tile) begins_[tile + 1] += begins_[tile];
    sorted_.resize(begins_.back());
    std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i)
        for_each_tile(triangles_[i], [&](std::uint32_t tile) { sorted_[next[tile]++] = i; });
}

void draw_tile(const Draw& draw, std::span<const Chunk> chunks, const Tiles& tiles, std::uint32_t tile) {
    const std::int32_t blocks = tiles.side / block_side;
    const auto x = static_cast<std::int32_t>(tile % tiles.across), y = static_cast<std::int32_t>(tile / tiles.across);
    const Box inside{x * blocks, y * blocks, (x + 1) * blocks, (y + 1) * blocks};
    BlockDraw block(draw);
    for (const Chunk& chunk : chunks)
        for (const std::uint32_t i : chunk.in_tile(tile)) {
            const Triangle& triangle = chunk.triangles()[i];
            for_each(common(squares_of(triangle, block_side), inside), [&](std::int32_t column, std::int32_t row) {
                block.run(triangle, column * block_side, row * block_side);
            });
        }
}

}  // namespace glift::host::raster
