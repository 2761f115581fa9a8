// A model to paint on, random strokes, and what an octree of paint holds, as ordinary containers.
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

/// A sphere before a sheet that it touches, within [0, 1]^3.
mesh::Mesh model();

/// From random sides; the first one coarse, the next ones over and beside it.
std::vector<strokes::Stroke> random_strokes(unsigned count, unsigned seed);

/// 128^3, with so many pages.
OctreeSize small(Word pages = 1500);

struct State {
    Words table, pages;         ///< the entries of all pages; the numbers of those that are there, ascending
    std::vector<Words> texels;  ///< of each of these, four bytes a texel
    bool operator==(const State&) const = default;
};

State state_of(Canvas& canvas);

/// The octree of a state, in double precision; `levels` of it, pages of 16 cells.
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

    /// Between levels and nodes, linearly; x in nodes of level 0, from node 0 on.
    Colour sample(const std::array<double, 3>& x, double level) const;

    /// Pages of a level that share a node.
    std::vector<Page> around(const Place& node, Word level) const;
    bool all_around(const Place& node, Word level) const;
    /// Whether a page beside a node of a level is not there: its value follows from a coarser one.
    bool hangs(const Place& node, Word level) const { return !all_around(node, level); }

    /// The mean of the 27 nodes of the level below that lie about a node; none where it is not to be formed.
    std::optional<Colour> mean(const Place& node, Word level) const;

private:
    Colour sample(const std::array<double, 3>& x, Word level) const;
    Colour node(const Place& node, Word level) const;

    Word levels_;
    std::map<Page, const Words*> pages_;
};

}  // namespace paint_model
