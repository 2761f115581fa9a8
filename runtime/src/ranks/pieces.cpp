#include "pieces.h"

#include <algorithm>
#include <set>

namespace glift::detail {

namespace {

/// Some layers of elements of a plane of pages, or a whole plane of elements.
Piece piece_of(const Memory& memory, const Coverage& coverage, unsigned from, unsigned to, Planes planes,
               std::uint32_t first_layer, std::uint32_t layers) {
    const Paging* paging = coverage.space->paging.get();
    if (!paging)
        return {from,
                to,
                memory,
                nullptr,
                planes.first * coverage.layout.plane_bytes,
                planes.count() * coverage.layout.plane_bytes};
    return {from,
            to,
            memory,
            paging,
            first_layer * coverage.layer_bytes,
            layers * coverage.layer_bytes,
            planes,
            static_cast<std::uint32_t>(coverage.frame_bytes)};
}

void add(std::vector<Piece>& pieces, Piece piece) {
    if (piece.most_bytes() != 0) pieces.push_back(std::move(piece));
}

void add_dense_ghosts(std::vector<Piece>& pieces, const Memory& memory, const Coverage& coverage, unsigned to,
                      std::uint32_t width, const SlabLayout& edges) {
    const Cuts& cuts = coverage.space->cuts;
    const Planes own = cuts.of(to);
    std::set<std::uint32_t> needed;
    const auto need = [&](std::int64_t coordinate) {
        const std::int64_t farthest = SlabLayout::farthest;
        if (coordinate < -farthest || coordinate >= std::int64_t{edges.planes} + farthest) return;
        const std::uint32_t plane = edges.plane_at(coordinate);
        if (plane != SlabLayout::nowhere && cuts.owner(plane) != to) needed.insert(plane);
    };
    for (std::int64_t d = 1; d <= width; ++d) {
        need(std::int64_t{own.first} - d);
        need(std::int64_t{own.end} + d - 1);
    }
    for (auto at = needed.begin(); at != needed.end();) {
        const std::uint32_t first = *at;
        const unsigned from = cuts.owner(first);
        std::uint32_t end = first;
        while (at != needed.end() && *at == end && cuts.owner(end) == from) ++end, ++at;
        add(pieces, piece_of(memory, coverage, from, to, {first, end}, 0, 0));
    }
}

void add_paged_ghosts(std::vector<Piece>& pieces, const Memory& memory, const Coverage& coverage, unsigned to,
                      std::uint32_t width) {
    const Cuts& cuts = coverage.space->cuts;
    const Planes own = cuts.of(to);
    const std::uint32_t layers = coverage.space->paging->layers;
    for (std::uint32_t beyond = 0; beyond * layers < width; ++beyond) {
        const std::uint32_t wanted = std::min(layers, width - beyond * layers);
        if (own.first > beyond) {
            const std::uint32_t plane = own.first - 1 - beyond;
            add(pieces, piece_of(memory, coverage, cuts.owner(plane), to, {plane, plane + 1}, layers - wanted, wanted));
        }
        if (own.end + beyond < cuts.planes()) {
            const std::uint32_t plane = own.end + beyond;
            add(pieces, piece_of(memory, coverage, cuts.owner(plane), to, {plane, plane + 1}, 0, wanted));
        }
    }
}

}  // namespace

std::vector<Piece> ghost_pieces(const Memory& memory, const Coverage& coverage, std::uint32_t width,
                                const SlabLayout& edges) {
    std::vector<Piece> pieces;
    for (unsigned to = 0; to < coverage.space->cuts.ranks(); ++to) {
        if (coverage.space->cuts.of(to).count() == 0) continue;
        if (coverage.space->paging) add_paged_ghosts(pieces, memory, coverage, to, width);
        else add_dense_ghosts(pieces, memory, coverage, to, width, edges);
    }
    return pieces;
}

std::vector<Piece> gather_pieces(const Memory& memory, const Coverage& coverage, Planes of_each) {
    const Cuts& cuts = coverage.space->cuts;
    const std::uint32_t layers = coverage.space->paging ? coverage.space->paging->layers : 0;
    std::vector<Piece> pieces;
    for (unsigned from = 0; from < cuts.ranks(); ++from) {
        const Planes own = cuts.of(from);
        const Planes part = {std::min(own.first + of_each.first, own.end), std::min(own.first + of_each.end, own.end)};
        if (part.count() == 0) continue;
        for (unsigned to = 0; to < cuts.ranks(); ++to)
            if (to != from) add(pieces, piece_of(memory, coverage, from, to, part, 0, layers));
    }
    return pieces;
}

std::vector<Piece> migration_pieces(const Memory& memory, const Coverage& coverage, const Cuts& next) {
    const Cuts& now = coverage.space->cuts;
    const std::uint32_t layers = coverage.space->paging ? coverage.space->paging->layers : 0;
    std::vector<Piece> pieces;
    for (unsigned from = 0; from < now.ranks(); ++from) {
        for (unsigned to = 0; to < now.ranks(); ++to) {
            const Planes part = {std::max(now.of(from).first, next.of(to).first),
                                 std::min(now.of(from).end, next.of(to).end)};
            if (from != to && part.count() != 0) add(pieces, piece_of(memory, coverage, from, to, part, 0, layers));
        }
    }
    return pieces;
}

std::uint64_t most_bytes_of_plane(const Coverage& coverage) {
    const Paging* paging = coverage.space->paging.get();
    if (!paging) return coverage.layout.plane_bytes;
    std::uint32_t most = 0;
    for (std::uint32_t plane = 0; plane < coverage.space->cuts.planes(); ++plane)
        most = std::max(most, paging->pages({plane, plane + 1}).count());
    return most * coverage.frame_bytes;
}

}  // namespace glift::detail
