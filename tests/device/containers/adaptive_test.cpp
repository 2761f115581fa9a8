// Quadtrees and octrees of random pages and random values, sampled everywhere, on the edges of pages and at hanging
// nodes too, compared with an interpolator of doubles that knows nothing of frames and tables.
#include "property.h"

#include "adaptive.glift.hpp"

#include <array>
#include <cmath>
#include <set>

namespace {

using glift::float4;
using glift::uint4;
using property::Round;
using Number = std::uint32_t;

GLIFT_PROPERTY_SUITE(Adaptive);

/// The weights of a GPU's filter have 8 bits, of each axis; elsewhere a point in the image of frames has 24. Values are
/// between -1 and 1.
constexpr double filter_error = 3 * 2.0 / 256, exact_error = 1e-4;

Number mixed(Number x) {
    const Number a = (x ^ (x >> 16)) * 0x7feb352dU, b = (a ^ (a >> 15)) * 0x846ca68bU;
    return b ^ (b >> 16);
}

template <int N> using Place = std::array<Number, N>;
template <int N> using Point = std::array<double, N>;

/// The field, from the pages that are there.
template <int N> class Field {
public:
    struct Page {
        Number level;
        Place<N> at;
        auto operator<=>(const Page&) const = default;
    };

    Field(Number levels, Number cells, bool smooth) : levels_(levels), cells_(cells), smooth_(smooth) {}

    Number along(Number level) const { return 1U << (levels_ - 1 - level); }
    const std::set<Page>& pages() const { return pages_; }
    void put(const Page& page) { pages_.insert(page); }
    void clear() { pages_.clear(); }

    /// Parents stand for the pages of a level.
    void raise(Number level) {
        std::set<Page> raised;
        for (Page page : pages_) {
            if (page.level == level) {
                ++page.level;
                for (Number& at : page.at) at /= 2;
            }
            raised.insert(page);
        }
        pages_ = std::move(raised);
    }

    /// All pages that have a node.
    std::vector<Page> with_node(const Place<N>& node, Number level) const {
        std::vector<Page> found;
        for (Number corner = 0; corner < 1U << N; ++corner) {
            Page page{level, {}};
            for (int axis = 0; axis < N; ++axis) {
                const Number back = (corner >> axis & 1) != 0 && node[axis] > 0 ? 1 : 0;
                page.at[axis] = std::min((node[axis] - back) / cells_, along(level) - 1);
            }
            found.push_back(page);
        }
        return found;
    }

    /// x in nodes of level 0, from node 0 on.
    double sample(Point<N> x, Number level) const {
        Page page{level, {}};
        for (int axis = 0; axis < N; ++axis) {
            x[axis] = std::clamp(x[axis], 0.0, double(cells_ * along(0)));
            page.at[axis] = std::min(Number(x[axis] / double(cells_ << level)), along(level) - 1);
        }
        const Page* best = find(page);
        return best == nullptr ? 0 : interpolated(*best, x);
    }

private:
    const Page* find(Page page) const {
        for (;; ++page.level) {
            if (const auto found = pages_.find(page); found != pages_.end()) return &*found;
            if (page.level + 1 == levels_) return nullptr;
            for (Number& at : page.at) at /= 2;
        }
    }

    double interpolated(const Page& page, const Point<N>& x) const {
        Place<N> low{};
        Point<N> part{};
        for (int axis = 0; axis < N; ++axis) {
            const double node = x[axis] / double(1U << page.level);
            const Number first = page.at[axis] * cells_;
            low[axis] = std::min(std::max(Number(node), first), first + cells_ - 1);
            part[axis] = std::clamp(node - low[axis], 0.0, 1.0);
        }
        double sum = 0;
        for (Number corner = 0; corner < 1U << N; ++corner) {
            double weight = 1;
            Place<N> node = low;
            for (int axis = 0; axis < N; ++axis) {
                const bool up = (corner >> axis & 1) != 0;
                weight *= up ? part[axis] : 1 - part[axis];
                node[axis] += up;
            }
            if (weight > 0) sum += weight * value(node, page.level);
        }
        return sum;
    }

    /// Of a node as pages of its level have it: what the coarsest page beside it says.
    double value(const Place<N>& node, Number level) const {
        const Page* coarsest = nullptr;
        for (const Page& page : with_node(node, level))
            if (const Page* best = find(page); best && best->level > (coarsest ? coarsest->level : level))
                coarsest = best;
        if (coarsest == nullptr) return written(node, level);
        Point<N> x;
        for (int axis = 0; axis < N; ++axis) x[axis] = double(node[axis]) * (1U << level);
        return interpolated(*coarsest, x);
    }

    double written(const Place<N>& node, Number level) const {
        std::array<Number, 3> at{};
        std::ranges::copy(node, at.begin());
        if (smooth_)
            return 0.01F * float(at[0] << level) - 0.02F * float(at[1] << level) + 0.005F * float(at[2] << level);
        return 0.001 * (int(mixed(at[0] + mixed(at[1] + mixed(at[2] + mixed(level)))) % 2001) - 1000);
    }

    Number levels_, cells_;
    bool smooth_;
    std::set<Page> pages_;
};

template <int N, class Tree> class Trees {
public:
    Trees(const glift::Device& device, Round& round, Number cells)
        : device_(device), round_(round), levels_(2 + round.below(4)), cells_(cells), smooth_(round.chance(3)),
          capacity_(is_coarsened ? 1 + round.below(60)
                    : N == 2     ? 400
                                 : 1200),
          field_(levels_, cells, smooth_), tree_(device, levels_, capacity_) {
        round.about("levels " + std::to_string(levels_) + (smooth_ ? ", smooth" : ""));
    }

    void run() {
        for (int step = 0; step < 4 && !testing::Test::HasFailure(); ++step) {
            change();
            ASSERT_EQ(tree_.status(device_).refused, 0u);
            ASSERT_EQ(tree_.status(device_).resident, field_.pages().size()) << round_.wrong("pages").message();
            compare(anywhere());
            compare(on_edges());
        }
    }

private:
    /// The coarsest page and those of some nodes.
    void change() {
        if (is_coarsened) field_.clear();
        std::vector<uint4> asked{{0, 0, 0, levels_ - 1}};
        field_.put({levels_ - 1, {}});
        for (Number i = round_.below(12); i-- > 0;) {
            const Number level = round_.below(levels_), nodes = cells_ * field_.along(level) + 1;
            Place<N> node;
            for (Number& at : node) at = round_.below(nodes);
            asked.push_back({node[0], node[1], N == 3 ? node[N - 1] : 0, level});
            for (const auto& page : field_.with_node(node, level)) field_.put(page);
        }
        adaptive::Requests requests(device_, Number(asked.size()));
        requests.write(asked);
        adaptive::change(device_, requests, smooth_, tree_);
        for (Number level = 0; level + 1 < levels_ && field_.pages().size() > capacity_; ++level) field_.raise(level);
    }

    double width() const { return double(cells_ * field_.along(0)); }

    std::vector<Point<N>> anywhere() {
        std::vector<Point<N>> points(200);
        for (Point<N>& point : points)
            for (double& x : point) x = (round_.real() * 0.55 + 0.5) * width();
        return points;
    }

    /// Points on a face, an edge or a corner of a page, and others a hair beside them.
    std::vector<Point<N>> on_edges() {
        std::vector<Point<N>> points = anywhere();
        for (Point<N>& point : points)
            for (double& x : point)
                if (!round_.chance(3)) x = std::round(x / cells_) * cells_ + (round_.below(3) - 1.0) * 1e-3;
        return points;
    }

    void compare(const std::vector<Point<N>>& points) {
        std::vector<float4> given;
        std::vector<double> exact, bounds;
        for (const Point<N>& point : points) {
            const float level = round_.chance(2) ? 0.0F : float(round_.below(4 * levels_)) * 0.25F;
            given.push_back(
                {float(point[0]) + 0.5F, float(point[1]) + 0.5F, N == 3 ? float(point[N - 1]) + 0.5F : 0, level});
            Point<N> x = point;
            for (int axis = 0; axis < N; ++axis) x[axis] = double((&given.back().x)[axis]) - 0.5;
            const double l = std::clamp(double(level), 0.0, double(levels_ - 1)), part = l - std::floor(l);
            const double fine = field_.sample(x, Number(l));
            const double coarse = field_.sample(x, std::min(Number(l) + 1, levels_ - 1));
            exact.push_back(fine * (1 - part) + coarse * part);
            bounds.push_back(device_.properties().kind == glift::DeviceKind::gpu ? filter_error : exact_error);
        }
        adaptive::Points x(device_, Number(given.size()));
        x.write(given);
        const adaptive::Line y(device_, Number(given.size()));
        adaptive::sample(device_, x, tree_, y);
        ASSERT_TRUE(property::near(round_, exact, bounds, y.read(), "sample"));
    }

    static constexpr bool is_coarsened = std::is_same_v<Tree, adaptive::Coarsened>;

    glift::Device device_;
    Round& round_;
    Number levels_, cells_;
    bool smooth_;
    Number capacity_;
    Field<N> field_;
    Tree tree_;
};

TEST_P(Adaptive, Quadtrees) {
    for_all("quadtree", [&](Round& round) { Trees<2, adaptive::Quadtree>(device(), round, 4).run(); });
}

/// Requests that do not fit are granted on coarser levels, and what was not requested goes.
TEST_P(Adaptive, Coarsened) {
    for_all("coarsened", [&](Round& round) { Trees<2, adaptive::Coarsened>(device(), round, 4).run(); });
}

TEST_P(Adaptive, Octrees) {
    for_all("octree", [&](Round& round) { Trees<3, adaptive::Octree>(device(), round, 2).run(); });
}

}  // namespace
