// Runs a draw in batches: first all chunks of a batch in parallel, then all tiles.
#include "host/raster/batch.h"

#include <glift/host/parallel.h>

#include <algorithm>

namespace glift::host {

namespace {

constexpr std::uint32_t chunk_corners = 6 * 256;  // a multiple of 3 and 2: no triangle or line is cut
constexpr std::size_t batch_chunks = 64;

}  // namespace

void draw(const Draw& draw) {
    using namespace raster;
    const uint2 begin = draw.framebuffer % 2u;  // the quads of derivatives are aligned as on a GPU
    const Cull cull = draw.topology == Topology::triangles ? draw.cull : Cull::none;
    const Window window{begin, begin + draw.viewport, cull, {draw.clip_distances, draw.varyings}};
    const Clipper clipper(window);
    const Tiles tiles = tiles_of(window.end);
    const std::uint64_t corners = draw.corners / corners_of(draw.topology) * corners_of(draw.topology);
    const std::uint64_t chunks_of_instance = (corners + chunk_corners - 1) / chunk_corners;
    const std::uint64_t chunk_count = chunks_of_instance * draw.instances;
    std::vector<Chunk> chunks(std::min<std::uint64_t>(batch_chunks, chunk_count));
    for (std::uint64_t first = 0; first < chunk_count; first += batch_chunks) {
        const std::size_t count = std::min<std::uint64_t>(batch_chunks, chunk_count - first);
        detail::spread(count, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::uint64_t corner = (first + i) % chunks_of_instance * chunk_corners;
                chunks[i].make(draw, window, clipper, tiles, corner,
                               static_cast<std::uint32_t>(std::min<std::uint64_t>(chunk_corners, corners - corner)),
                               static_cast<std::uint32_t>((first + i) / chunks_of_instance));
            }
        });
        detail::spread(tiles.count(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t tile = begin; tile < end; ++tile)
                draw_tile(draw, {chunks.data(), count}, tiles, static_cast<std::uint32_t>(tile));
        });
    }
}

}  // namespace glift::host
