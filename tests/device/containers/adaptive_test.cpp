// Adaptive fields (quadtrees and octrees) with random pages and values, sampled everywhere, also on the edges of pages
// and at hanging nodes; compared with an interpolator in double precision that has no frames or tables. For pools that
// are too small, each policy is compared with a model of which pages are resident: evict_coarsen in
// evict_coarsen_test.cpp, the others here.
#include "model.h"
#include "property.h"
#include "tree_model.h"

#include "adaptive.glift.hpp"

#include <array>
#include <cmath>

namespace {

using glift::float4;
using glift::uint4;
using property::Round;
using Number = std::uint32_t;

GLIFT_PROPERTY_SUITE(Adaptive);

/// Bounds on the error of samples of values that differ by at most 2. The weights of a GPU's linear filter have 8 bits
/// for each axis; elsewhere the error comes from coordinates in the image of frames, which have 24 bits.
constexpr double filter_error = 3 * 2.0 / 256, exact_error = 1e-4;

Number mixed(Number x) {
    const Number a = (x ^ (x >> 16)) * 0x7feb352dU, b = (a ^ (a >> 15)) * 0x846ca68bU;
    return b ^ (b >> 16);
}

using model::Place;
template <int N> using Point = std::array<double, N>;

/// The model: the field as interpolated from the pages that are resident.
template <int N> class Field : public model::Tree<N> {
public:
    using Page = typename model::Tree<N>::Page;
    using model::Tree<N>::along;
    using model::Tree<N>::find;

    Field(Number levels, Number cells, bool smooth, bool repeats)
        : model::Tree<N>(levels), cells_(cells), smooth_(smooth), repeats_(repeats) {}

    /// All pages of a level that share a node.
    std::vector<Page> with_node(const Place<N>& node, Number level) const {
        std::vector<Page> found;
        for (Number corner = 0; corner < 1U << N; ++corner) {
            Page page{level, {}};
            for (int axis = 0; axis < N; ++axis) {
                const Number size = cells_ * along(level), at = repeats_ ? node[axis] % size : node[axis];
                if ((corner >> axis & 1) == 0) page.at[axis] = std::min(at / cells_, along(level) - 1);
                else if (at > 0) page.at[axis] = (at - 1) / cells_;
                else page.at[axis] = repeats_ ? along(level) - 1 : 0;
            }
            found.push_back(page);
        }
        return found;
    }

    /// Samples at x, which is counted in nodes of level 0, from node 0 on.
    double sample(Point<N> x, Number level) const {
        Page page{level, {}};
        for (int axis = 0; axis < N; ++axis) {
            const double size = cells_ * along(0);
            x[axis] = repeats_ ? x[axis] - size * std::floor(x[axis] / size) : std::clamp(x[axis], 0.0, size);
            page.at[axis] = std::min(Number(x[axis] / double(cells_ << level)), along(level) - 1);
        }
        const Page* best = find(page);
        return best == nullptr ? 0 : interpolated(*best, x);
    }

private:
    double interpolated(const Page& page, const Point<N>& x) const {
        Place<N> low{};
        Point<N> part{};
        for (int axis = 0; axis < N; ++axis) {
            const Number first = page.at[axis] * cells_;
            double node = x[axis] / double(1U << page.level);
            if (repeats_ && node < first) node += cells_ * along(page.level);
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

    /// The value of a node in pages of its level: where a coarser page is beside it (a hanging node), the interpolant
    /// of the coarsest.
    double value(Place<N> node, Number level) const {
        for (Number& at : node)
            if (repeats_) at %= cells_ * along(level);
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

    Number cells_;
    bool smooth_, repeats_;
};

enum class Policy { enough, coarsen, fail, drop, evict, grow };

/// The largest difference between samples on the two sides of a page's edge, less the change of the exact field between
/// them.
struct Jump {
    double largest = 0;
    int edges = 0;
};

template <int N, class Tree> class Trees {
public:
    Trees(const glift::Device& device, Round& round, Number cells, Policy policy, Jump& jump, bool repeats = false)
        : device_(device), round_(round), levels_(2 + round.below(4)), cells_(cells), smooth_(round.chance(3)),
          policy_(policy), jump_(jump), field_(levels_, cells, smooth_, repeats), capacity_(capacity_of(policy)),
          pages_(model_of(policy), field_.count(), capacity_), tree_(device, levels_, capacity_) {
        round_.about("levels " + std::to_string(levels_) + ", capacity " + std::to_string(capacity_) +
                     (smooth_ ? ", smooth" : ""));
    }

    void run() {
        constexpr int steps = N == 3 ? 2 : 3;
        for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) {
            change();
            ASSERT_EQ(tree_.status(device_).resident, field_.pages().size()) << round_.wrong("pages").message();
            if (policy_ == Policy::coarsen) ASSERT_EQ(tree_.status(device_).refused, 0u);
            else ASSERT_TRUE(layout_is_right());
            compare(anywhere());
            compare(on_edges());
            measure_jumps();
        }
    }

private:
    static model::Overflow model_of(Policy policy) {
        return policy == Policy::fail    ? model::Overflow::fail
               : policy == Policy::evict ? model::Overflow::evict
               : policy == Policy::grow  ? model::Overflow::grow
                                         : model::Overflow::drop;
    }

    /// The pool's capacity: enough for all pages that may be requested, or 1/2 to 1/16 of all pages; for `coarsen` 1 to
    /// 60.
    Number capacity_of(Policy policy) {
        if (policy == Policy::enough) return N == 2 ? 400 : 1200;
        return policy == Policy::coarsen ? 1 + round_.below(60) : std::max(1U, field_.count() >> 1 >> round_.below(4));
    }

    void ask(const typename Field<N>::Page& page) {
        if (policy_ == Policy::coarsen) field_.put(page);
        else pages_.request(field_.number_of(page));
    }

    /// Requests the coarsest page and the pages of some nodes, both from the tree and from the model; changes both.
    void change() {
        field_.clear();
        std::vector<uint4> asked{{0, 0, 0, levels_ - 1}};
        ask({levels_ - 1, {}});
        for (Number i = round_.below(12); i-- > 0;) {
            const Number level = round_.below(levels_), nodes = cells_ * field_.along(level) + 1;
            Place<N> node;
            for (Number& at : node) at = round_.below(nodes);
            asked.push_back({node[0], node[1], N == 3 ? node[N - 1] : 0, level});
            for (const auto& page : field_.with_node(node, level)) ask(page);
        }
        adaptive::Requests requests(device_, Number(asked.size()));
        requests.write(asked);
        adaptive::change(device_, requests, smooth_, tree_);
        if (policy_ == Policy::coarsen) {
            field_.coarsen(capacity_);
            return;
        }
        pages_.change(false);
        for (const auto& [page, frame] : pages_.frames()) field_.put(field_.page_of(page));
    }

    /// Compares status and table of pages with the model of the policy.
    testing::AssertionResult layout_is_right() {
        const auto status = tree_.status(device_);
        const model::Status found{status.requested, status.granted, status.refused, status.resident, status.capacity};
        if (!(found == pages_.status())) return round_.wrong("status");
        std::vector<Number> entries(field_.count());
        for (const auto& [page, frame] : pages_.frames()) entries[page] = frame + 1;
        return property::equal(round_, entries, model::own(tree_.best().read()), "entries");
    }

    double width() const { return double(cells_ * field_.along(0)); }

    std::vector<Point<N>> anywhere() {
        std::vector<Point<N>> points(200);
        for (Point<N>& point : points)
            for (double& x : point) x = (round_.real() * 0.55 + 0.5) * width();
        return points;
    }

    /// Random points; most coordinates are those of a page's side, or 1e-3 beside it.
    std::vector<Point<N>> on_edges() {
        std::vector<Point<N>> points = anywhere();
        for (Point<N>& point : points)
            for (double& x : point)
                if (!round_.chance(3)) x = std::round(x / cells_) * cells_ + (round_.below(3) - 1.0) * 1e-3;
        return points;
    }

    float4 point_of(const Point<N>& x, float level) const {
        return {float(x[0]) + 0.5F, float(x[1]) + 0.5F, N == 3 ? float(x[N - 1]) + 0.5F : 0, level};
    }

    double exact_at(float4 given) const {
        Point<N> x;
        for (int axis = 0; axis < N; ++axis) x[axis] = double((&given.x)[axis]) - 0.5;
        const double l = std::clamp(double(given.w), 0.0, double(levels_ - 1)), part = l - std::floor(l);
        const double fine = field_.sample(x, Number(l));
        const double coarse = field_.sample(x, std::min(Number(l) + 1, levels_ - 1));
        return fine * (1 - part) + coarse * part;
    }

    double bound() const { return device_.properties().kind == glift::DeviceKind::gpu ? filter_error : exact_error; }

    std::vector<float> sampled(const std::vector<float4>& given) {
        adaptive::Points x(device_, Number(given.size()));
        x.write(given);
        const adaptive::Line y(device_, Number(given.size()));
        adaptive::sample(device_, x, tree_, y);
        return y.read();
    }

    void compare(const std::vector<Point<N>>& points) {
        std::vector<float4> given;
        std::vector<double> exact;
        for (const Point<N>& point : points) {
            given.push_back(point_of(point, round_.chance(2) ? 0.0F : float(round_.below(4 * levels_)) * 0.25F));
            exact.push_back(exact_at(given.back()));
        }
        const std::vector<double> bounds(exact.size(), bound());
        ASSERT_TRUE(property::near(round_, exact, bounds, sampled(given), "sample"));
    }

    /// Samples on both sides of faces of pages, some also at an edge, a corner or the border of the field.
    void measure_jumps() {
        constexpr double aside = 1.0 / 4096;
        std::vector<float4> given;
        for (Point<N> point : on_edges()) {
            const int axis = int(round_.below(N));
            const double edge = std::round(point[axis] / cells_) * cells_;
            for (const double side : {-aside, aside}) {
                point[axis] = edge + side;
                given.push_back(point_of(point, 0));
            }
        }
        const std::vector<float> found = sampled(given);
        for (std::size_t i = 0; i < found.size(); i += 2) {
            const double change = exact_at(given[i + 1]) - exact_at(given[i]);
            jump_.largest = std::max(jump_.largest, std::abs(double(found[i + 1]) - found[i] - change));
            ++jump_.edges;
        }
        ASSERT_LE(jump_.largest, 2 * bound()) << round_.wrong("a jump").message();
    }

    glift::Device device_;
    Round& round_;
    Number levels_, cells_;
    bool smooth_;
    Policy policy_;
    Jump& jump_;
    Field<N> field_;
    Number capacity_;
    model::Pages pages_;
    Tree tree_;
};

/// Prints how continuous the fields were.
void report(const glift::Device& device, const Jump& jump) {
    const std::string name = device.properties().name;
    testing::Test::RecordProperty("largest_jump", std::to_string(jump.largest));
    std::printf("%s: largest jump over %d edges of pages: %.2g (values -1 to 1)\n", name.c_str(), jump.edges,
                jump.largest);
}

TEST_P(Adaptive, Quadtrees) {
    Jump jump;
    for_all("quadtree",
            [&](Round& round) { Trees<2, adaptive::Quadtree>(device(), round, 4, Policy::enough, jump).run(); });
    report(device(), jump);
}

TEST_P(Adaptive, Octrees) {
    Jump jump;
    for_all("octree",
            [&](Round& round) { Trees<3, adaptive::Octree>(device(), round, 2, Policy::enough, jump).run(); });
    report(device(), jump);
}

/// Fields that repeat: pages at opposite borders are neighbours.
TEST_P(Adaptive, QuadtreesThatRepeat) {
    Jump jump;
    for_all("quadtree that repeats",
            [&](Round& round) { Trees<2, adaptive::Torus>(device(), round, 4, Policy::enough, jump, true).run(); });
    report(device(), jump);
}

TEST_P(Adaptive, OctreesThatRepeat) {
    Jump jump;
    for_all("octree that repeats", [&](Round& round) {
        Trees<3, adaptive::OctreeTorus>(device(), round, 2, Policy::enough, jump, true).run();
    });
    report(device(), jump);
}

/// Requests that do not fit are granted on coarser levels; pages that were not requested are released.
TEST_P(Adaptive, Coarsen) {
    Jump jump;
    for_all("coarsened",
            [&](Round& round) { Trees<2, adaptive::Coarsened>(device(), round, 4, Policy::coarsen, jump).run(); });
}

TEST_P(Adaptive, Drop) {
    Jump jump;
    for_all("tree, drop",
            [&](Round& round) { Trees<2, adaptive::Quadtree>(device(), round, 4, Policy::drop, jump).run(); });
}

TEST_P(Adaptive, Fail) {
    Jump jump;
    for_all("tree, fail",
            [&](Round& round) { Trees<2, adaptive::Failing>(device(), round, 4, Policy::fail, jump).run(); });
}

TEST_P(Adaptive, Evict) {
    Jump jump;
    for_all("tree, evict",
            [&](Round& round) { Trees<2, adaptive::Evicting>(device(), round, 4, Policy::evict, jump).run(); });
}

TEST_P(Adaptive, Grow) {
    Jump jump;
    for_all("tree, grow",
            [&](Round& round) { Trees<2, adaptive::Growing>(device(), round, 4, Policy::grow, jump).run(); });
}

/// A pool that grows has the same contents as one that was large from the start, bit for bit; pages keep their values.
TEST_P(Adaptive, GrowsToWhatALargeOneIs) {
    for_all("tree that grows", [&](Round& round) {
        const Number levels = 2 + round.below(4), all = (1U << 2 * levels) / 3, capacity = 1 + round.below(8);
        round.about("levels " + std::to_string(levels) + ", capacity " + std::to_string(capacity));
        adaptive::Growing grown(device(), levels, capacity), large(device(), levels, all);
        for (int step = 0; step < 4 && !HasFailure(); ++step) {
            std::vector<uint4> asked{{0, 0, 0, levels - 1}};
            for (Number i = round.below(8); i-- > 0;) {
                const Number level = round.below(levels), nodes = 4 * (1U << (levels - 1 - level)) + 1;
                asked.push_back({round.below(nodes), round.below(nodes), 0, level});
            }
            adaptive::Requests requests(device(), Number(asked.size()));
            requests.write(asked);
            adaptive::refine(device(), requests, grown);
            adaptive::refine(device(), requests, large);
            const Number n = large.status(device()).resident;
            ASSERT_EQ(grown.status(device()).resident, n);
            ASSERT_LT(grown.status(device()).capacity, std::max(2 * n, 9U));
            ASSERT_TRUE(property::equal(round, large.best().read(), grown.best().read(), "best"));
            ASSERT_TRUE(property::equal(round, large.frames().read({0, 0}, {25, n}),
                                        grown.frames().read({0, 0}, {25, n}), "frames"));
        }
    });
}

}  // namespace
