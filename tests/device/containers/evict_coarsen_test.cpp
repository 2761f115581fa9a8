// Quadtrees with the policy evict_coarsen. After random requests and releases, sometimes of many more pages than fit,
// they are compared with a model on the host (maps and sets of pages: model.h, tree_model.h): which pages are resident
// and in which frames, the counts, all values, and samples, also where a coarser page stands for the requested one.
#include "model.h"
#include "property.h"
#include "tree_model.h"

#include "evict_coarsen.glift.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using glift::float3;
using model::Number;
using property::Round;

GLIFT_PROPERTY_SUITE(EvictCoarsen);

constexpr Number cells = 4, nodes = cells + 1;

/// The bound on the error of samples, for values from -1 to 1. Points are chosen so that the weights of a linear filter
/// are multiples of 1/256. A GPU with 8 bits of sub-texel precision may still take the neighbouring multiple, since the
/// coordinate that it is given is a rounded quotient. Then the weight along each of the two axes is off by 1/256, and
/// mixes values that differ by at most 2.
double bound_on(const glift::Device& device) {
    return device.properties().kind == glift::DeviceKind::gpu ? 2 * 2.0 / 256 : 1e-4;
}

using Texels = std::array<double, nodes * nodes>;
using Point = std::array<double, 2>;

/// The resident pages and their values.
class Cached : public model::Tree<2> {
public:
    using model::Tree<2>::Tree;

    std::map<Number, Texels> values;  ///< by the pages' numbers

    /// The page of a level that contains a point. Coordinates are in cells of level 0; node 0 lies at 0.
    Page page_at(const Point& x, Number level) const {
        Page page{level, {}};
        for (int axis = 0; axis < 2; ++axis)
            page.at[axis] = std::min(static_cast<Number>(x[axis] / (cells << level)), along(level) - 1);
        return page;
    }

    double sample(const Point& x, Number level) const {
        const Page* page = find(page_at(x, level));
        if (page == nullptr) return 0;
        const Texels& texels = values.at(number_of(*page));
        std::array<Number, 2> low{};
        Point part{};
        for (int axis = 0; axis < 2; ++axis) {
            const double inside = x[axis] / (1U << page->level) - page->at[axis] * cells;
            low[axis] = std::min(static_cast<Number>(inside), cells - 1);
            part[axis] = inside - low[axis];
        }
        const auto row = [&](Number y) {
            const double* texel = &texels[y * nodes + low[0]];
            return texel[0] * (1 - part[0]) + texel[1] * part[0];
        };
        return row(low[1]) * (1 - part[1]) + row(low[1] + 1) * part[1];
    }

    /// The values that a new page begins with.
    Texels interpolated(const Page& page) const {
        Texels texels{};
        for (Number i = 0; i < texels.size(); ++i)
            texels[i] = sample({static_cast<double>((page.at[0] * cells + i % nodes) << page.level),
                                static_cast<double>((page.at[1] * cells + i / nodes) << page.level)},
                               page.level);
        return texels;
    }
};

class Sequence {
public:
    Sequence(const glift::Device& device, Round& round)
        : device_(device), round_(round), levels_(1 + round.below(5)), capacity_(1 + round.below(40)), there_(levels_),
          pages_(model::Overflow::evict, there_.count(), capacity_), tree_(device, levels_, capacity_) {
        round_.about("levels " + std::to_string(levels_) + ", capacity " + std::to_string(capacity_));
    }

    void run() {
        for (int step = 0; step < 6 && !testing::Test::HasFailure(); ++step) {
            change();
            ASSERT_TRUE(counts_are_right()) << "step " << step;
            ASSERT_TRUE(layout_is_right()) << "step " << step;
            ASSERT_TRUE(values_are_right()) << "step " << step;
            ASSERT_TRUE(samples_are_right()) << "step " << step;
            if (round_.chance(2)) write();
        }
    }

private:
    using Page = Cached::Page;

    evict_coarsen::Numbers on_device(const std::vector<Number>& all) {
        evict_coarsen::Numbers made(device_, static_cast<Number>(all.size()));
        made.write(all);
        return made;
    }

    /// Up to `most` random pages: two in three are of the finest level and near to each other along x; the others are
    /// of any level.
    std::vector<Number> some_pages(Number most) {
        std::vector<Number> numbers(round_.below(most + 1));
        const Number around = round_.below(there_.count());
        for (Number& number : numbers) {
            const Number level = round_.chance(3) ? round_.below(levels_) : 0, along = there_.along(level);
            const Number first = level == 0 ? around % along : 0, spread = level == 0 ? std::max(1U, along / 2) : along;
            number = there_.number_of({level, {(first + round_.below(spread)) % along, round_.below(along)}});
        }
        return numbers;
    }

    /// Requests and releases pages and makes the change, both in the tree and in the model.
    void change() {
        const std::vector<Number> asked = some_pages(round_.chance(3) ? 100 : 12),
                                  released = some_pages(round_.chance(3) ? 12 : 0);
        const bool releases_others = round_.chance(6);
        evict_coarsen::ask(device_, on_device(asked), on_device(released), tree_);
        if (releases_others) tree_.update(device_);
        else tree_.allocate(device_);

        asked_ = {asked.begin(), asked.end()};
        Cached wanted(levels_);
        for (const Number page : asked_) wanted.put(wanted.page_of(page));
        wanted.coarsen(capacity_);
        for (const Page& page : wanted.pages()) pages_.request(wanted.number_of(page));
        for (const Number page : released) pages_.release(page);
        granted_ = pages_.change(releases_others);
        begin_new();
    }

    /// Removes released pages from the model. New pages begin with values interpolated from the pages that stayed.
    void begin_new() {
        const std::set<Number> fresh(granted_.begin(), granted_.end());
        Cached stayed(levels_);
        for (const auto& [page, frame] : pages_.frames()) {
            if (fresh.contains(page)) continue;
            stayed.put(stayed.page_of(page));
            stayed.values[page] = there_.values.at(page);
        }
        there_ = stayed;
        for (const Number page : granted_) {
            there_.put(there_.page_of(page));
            there_.values[page] = stayed.interpolated(stayed.page_of(page));
        }
    }

    /// Writes random values to all resident pages.
    void write() {
        std::vector<float> values;
        for (auto& [page, texels] : there_.values)
            for (double& texel : texels) {
                values.push_back(static_cast<float>(round_.real()));
                texel = static_cast<double>(values.back());
            }
        evict_coarsen::Values given(device_, {nodes * nodes, static_cast<Number>(there_.values.size())});
        given.write(values);
        evict_coarsen::write(device_, given, tree_);
    }

    testing::AssertionResult counts_are_right() {
        const auto status = tree_.status(device_);
        const model::Status found{status.requested, status.granted, status.refused, status.resident, status.capacity};
        if (!(found == pages_.status())) return round_.wrong("status");
        // Independent of the model: the policy refuses nothing, and no more pages are resident than there are frames.
        if (status.refused != 0 || status.resident > capacity_)
            return round_.wrong("a request was refused, or more pages are resident than fit");
        const auto missing = std::ranges::count_if(asked_, [&](Number page) { return !there_.values.contains(page); });
        if (tree_.coarsened(device_) != missing) return round_.wrong("coarsened");
        if (missing != 0 && asked_.size() <= capacity_) return round_.wrong("coarser though there was room");
        return testing::AssertionSuccess();
    }

    /// Compares the table, the lists of pages and the owners of frames with the model.
    testing::AssertionResult layout_is_right() {
        std::vector<Number> entries(there_.count()), active, frames, owners(capacity_);
        const std::vector<Number> found_used = tree_.pages().used().read();
        std::vector<Number> used = found_used;
        for (const auto& [page, frame] : pages_.frames()) {
            entries[page] = frame + 1;
            active.push_back(page);
            frames.push_back(frame);
            owners[frame] = page + 1;
            used[frame] = pages_.used(page);
        }
        const auto start = [](std::vector<Number> all, std::size_t n) {
            all.resize(n);
            return all;
        };
        const auto& pages = tree_.pages();
        const struct {
            const char* name;
            const std::vector<Number> expected, found;
        } all[] = {{"entries", entries, model::own(tree_.best().read())},
                   {"active", active, start(pages.active().read(), active.size())},
                   {"resident", frames, start(tree_.resident().read(), frames.size())},
                   {"granted", granted_, start(pages.granted().read(), granted_.size())},
                   {"owners", owners, pages.owners().read()},
                   {"used", used, found_used}};
        for (const auto& each : all)
            if (auto same = property::equal(round_, each.expected, each.found, each.name); !same) return same;
        return testing::AssertionSuccess();
    }

    testing::AssertionResult values_are_right() {
        const std::vector<float> frames = tree_.frames().read({0, 0}, {nodes * nodes, capacity_});
        std::vector<double> expected;
        std::vector<float> found;
        for (const auto& [page, texels] : there_.values) {
            expected.insert(expected.end(), texels.begin(), texels.end());
            const auto first = frames.begin() + pages_.frames().at(page) * nodes * nodes;
            found.insert(found.end(), first, first + nodes * nodes);
        }
        return property::near(round_, expected, std::vector<double>(expected.size(), bound_on(device_)), found,
                              "values");
    }

    /// Samples in the pages that were requested, at their levels, and in random pages.
    testing::AssertionResult samples_are_right() {
        std::vector<float3> given;
        std::vector<double> expected;
        std::vector<Number> levels;
        const auto add = [&](const Page& page) {
            Point x{};
            for (int axis = 0; axis < 2; ++axis)
                x[axis] = (page.at[axis] * cells << page.level) + round_.below(cells * 8 << page.level) / 8.0;
            given.push_back(
                {static_cast<float>(x[0]) + 0.5F, static_cast<float>(x[1]) + 0.5F, static_cast<float>(page.level)});
            const Page* best = there_.find(page);
            levels.push_back(best == nullptr ? levels_ : best->level);
            expected.push_back(there_.sample(x, page.level));
        };
        for (const Number page : asked_) {
            add(there_.page_of(page));
            if (levels.back() == levels_) return round_.wrong("nothing stands for what was asked for");
        }
        for (int i = 0; i < 40; ++i) add(there_.page_of(round_.below(there_.count())));
        const auto n = static_cast<Number>(given.size());
        evict_coarsen::Points points(device_, n);
        points.write(given);
        const evict_coarsen::Numbers found_levels(device_, n);
        const evict_coarsen::Line found(device_, n);
        evict_coarsen::levels_at(device_, points, tree_, found_levels);
        evict_coarsen::sample(device_, points, tree_, found);
        if (auto same = property::equal(round_, levels, found_levels.read(), "level"); !same) return same;
        return property::near(round_, expected, std::vector<double>(n, bound_on(device_)), found.read(), "sample");
    }

    glift::Device device_;
    Round& round_;
    Number levels_, capacity_;
    Cached there_;
    model::Pages pages_;
    evict_coarsen::Tree tree_;
    std::set<Number> asked_;       ///< pages requested for the last change
    std::vector<Number> granted_;  ///< pages granted in the last change, ascending
};

TEST_P(EvictCoarsen, CachesAndCoarsens) {
    for_all("tree, evict_coarsen", [&](Round& round) { Sequence(device(), round).run(); });
}

}  // namespace
