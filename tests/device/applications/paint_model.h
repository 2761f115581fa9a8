// A model to paint on, random strokes, and the contents of an octree of paint (examples/paint) in ordinary containers.
#pragma once

#include "examples/paint/canvas.h"
#include "examples/paint/model.h"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace paint_model {

using Word = glift::uint;
using Words = std::vector<Word>;

/// A sphere close in front of a sheet, within [0, 1]^3.
mesh::Mesh model();

/// Strokes on that model from random directions: the first by a large brush, the others by smaller ones.
std::vector<strokes::Stroke> random_strokes(unsigned count, unsigned seed);

/// A stroke of one dab in the middle of the square [0, 1]^2 at z = 0.25, seen from its front.
strokes::Stroke one_dab();

/// The settings of an octree of 128^3 cells with a pool of `pages` pages.
OctreeSize small(Word pages = 1500);

struct State {
    Words table, pages;         ///< the page table; the numbers of the resident pages, ascending
    std::vector<Words> texels;  ///< the texels of each resident page, four bytes each
    bool operator==(const State&) const = default;
};

State state_of(Canvas& canvas);

/// Reads the octree of a state, which has `levels` levels, in double precision. Level 0 is the finest. A page has 16
/// cells, and so 17 nodes with a texel each, along each axis.
class Field {
public:
    using Place = std::array<Word, 3>;
    using Colour = std::array<double, 4>;

    Field(const State& state, Word levels);

    struct Page {
        Word level;
        Place at;
        auto operator<=>(const Page&) const = default;
    };

    const std::map<Page, const Words*>& pages() const { return pages_; }
    Word along(Word level) const { return 1u << (levels_ - 1 - level); }
    bool has(const Page& page) const { return pages_.contains(page); }
    Colour texel(const Page& page, const Place& inside) const;

    /// Filtered linearly between nodes and between levels; x is counted in nodes of level 0, from node 0 on.
    Colour sample(const std::array<double, 3>& x, double level) const;

    /// The pages of a level that share a node, resident or not; eight pages, some of which may be the same one.
    std::vector<Page> around(const Place& node, Word level) const;
    bool all_around(const Place& node, Word level) const;
    /// Whether a page that shares a node of a level is not resident: then a coarser page decides the node's value.
    bool hangs(const Place& node, Word level) const { return !all_around(node, level); }

    /// The weighted mean colour of the painted ones among the up to 27 nodes of the next finer level about a node, and
    /// the largest of their fourth components; none on level 0, or where one of the pages that share the node on the
    /// finer level is not resident, or none of the 27 nodes is painted.
    std::optional<Colour> mean(const Place& node, Word level) const;

private:
    Colour sample(const std::array<double, 3>& x, Word level) const;
    Colour node(const Place& node, Word level) const;

    Word levels_;
    std::map<Page, const Words*> pages_;
};

}  // namespace paint_model
