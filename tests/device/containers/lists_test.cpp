// Linked lists, stacks, queues and grids of lists: random operations, compared with models made of the C++
// library's containers.
#include "property.h"

#include "lists.glift.hpp"

#include <algorithm>
#include <deque>
#include <map>

namespace {

using property::Round;
using Number = std::uint32_t;

GLIFT_PROPERTY_SUITE(Lists);

constexpr Number nothing = 0xffffffff;

std::vector<Number> numbers(Round& round, std::size_t n, std::uint64_t bound = 1u << 31) {
    std::vector<Number> all(n);
    for (Number& each : all) each = round.below(bound);
    return all;
}

lists::Numbers on_device(const glift::Device& device, const std::vector<Number>& all) {
    lists::Numbers line(device, static_cast<Number>(all.size()));
    line.write(all);
    return line;
}

std::vector<Number> first(std::vector<Number> all, std::size_t n) {
    all.resize(n);
    return all;
}

/// The model of linked lists: nodes are taken in the order of the pushes.
struct Linked {
    std::vector<Number> heads, links, items;
    Number capacity, refused = 0;

    void push(Number cell, Number item) {
        if (cell >= heads.size()) return;
        if (items.size() == capacity) {
            ++refused;
            return;
        }
        links.push_back(heads[cell]);
        heads[cell] = ~static_cast<Number>(items.size());
        items.push_back(item);
    }

    /// The items of each list, from the front.
    std::vector<std::vector<Number>> walked() const {
        std::vector<std::vector<Number>> all(heads.size());
        for (std::size_t cell = 0; cell < heads.size(); ++cell)
            for (Number node = ~heads[cell]; node != nothing; node = ~links[node]) all[cell].push_back(items[node]);
        return all;
    }
};

testing::AssertionResult same(const Round& round, const Linked& model, const lists::Linked& found,
                              const glift::Device& device) {
    const std::size_t n = model.items.size();
    if (found.size(device) != n) return round.wrong("number of nodes");
    if (found.refused(device) != model.refused) return round.wrong("refused");
    if (auto equal = property::equal(round, model.heads, found.heads().read(), "heads"); !equal) return equal;
    if (auto equal = property::equal(round, model.links, first(found.links().read(), n), "links"); !equal) return equal;
    return property::equal(round, model.items, first(found.items().read(), n), "items");
}

TEST_P(Lists, LinkedInBatches) {
    for_all("linked lists", [&](Round& round) {
        const Number cells = round.below(100), capacity = round.below(2000);
        lists::Linked found(device(), cells, capacity);
        const Linked empty{std::vector<Number>(cells), {}, {}, capacity};
        Linked model = empty;
        for (int step = 0; step < 12 && !HasFailure(); ++step) {
            const std::vector<Number> to = numbers(round, round.below(500), cells + 5),
                                      items = numbers(round, to.size());
            found.push_all(device(), on_device(device(), to), on_device(device(), items));
            for (std::size_t i = 0; i < to.size(); ++i) model.push(to[i], items[i]);
            if (round.chance(6)) {
                found.clear(device());
                model = empty;
            }
            ASSERT_TRUE(same(round, model, found, device()));
        }
    });
}

/// Kernels push in any order, so each list is compared as a multiset.
TEST_P(Lists, LinkedFromKernels) {
    for_all("linked lists, kernels", [&](Round& round) {
        const Number cells = 1 + round.below(100);
        lists::Linked lists(device(), cells, 4000);
        Linked model{std::vector<Number>(cells), {}, {}, 4000};
        for (int step = 0; step < 6 && !HasFailure(); ++step) {
            const std::vector<Number> to = numbers(round, round.below(500), cells + 5),
                                      items = numbers(round, to.size());
            lists::push_linked(device(), on_device(device(), to), on_device(device(), items), lists);
            for (std::size_t i = 0; i < to.size(); ++i) model.push(to[i], items[i]);
            Linked found{lists.heads().read(), lists.links().read(), lists.items().read(), 4000};
            auto expected = model.walked(), walked = found.walked();
            for (Number cell = 0; cell < cells; ++cell) {
                std::ranges::sort(expected[cell]);
                std::ranges::sort(walked[cell]);
                ASSERT_TRUE(property::equal(round, expected[cell], walked[cell], "list"));
            }
        }
    });
}

TEST_P(Lists, Grids) {
    for_all("grid of lists", [&](Round& round) {
        const Number cells = round.below(300), capacity = round.below(3000);
        lists::Grid grid(device(), cells, capacity);
        for (int step = 0; step < 6 && !HasFailure(); ++step) {
            const std::vector<Number> in = numbers(round, round.below(2500), cells + 3),
                                      items = numbers(round, in.size());
            grid.build(device(), on_device(device(), in), on_device(device(), items));
            std::map<Number, std::vector<Number>> model;
            for (std::size_t i = 0; i < in.size(); ++i)
                if (in[i] < cells) model[in[i]].push_back(items[i]);
            std::vector<Number> starts(cells + 1), all;
            for (Number cell = 0; cell < cells; ++cell) {
                all.insert(all.end(), model[cell].begin(), model[cell].end());
                starts[cell + 1] = std::min(static_cast<Number>(all.size()), capacity);
            }
            const auto refused = static_cast<Number>(all.size()) - starts[cells];
            all.resize(starts[cells]);
            ASSERT_TRUE(property::equal(round, starts, grid.starts().read(), "starts"));
            ASSERT_TRUE(property::equal(round, all, first(grid.items().read(), all.size()), "items"));
            ASSERT_EQ(grid.refused(device()), refused);
        }
    });
}

/// For each container: how kernels push to it, and which elements of the model n pops take. Which of the popping
/// invocations gets which element is unspecified.
template <class Container> struct Ends;

template <> struct Ends<lists::NumberStack> {
    static constexpr auto push = &lists::push_stack;
    static std::vector<Number> take(std::deque<Number>& all, std::size_t n) {
        std::vector<Number> taken(all.end() - static_cast<std::ptrdiff_t>(n), all.end());
        all.resize(all.size() - n);
        return taken;
    }
};

template <> struct Ends<lists::NumberQueue> {
    static constexpr auto push = &lists::push_queue;
    static std::vector<Number> take(std::deque<Number>& all, std::size_t n) {
        std::vector<Number> taken(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
        all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
        return taken;
    }
};

void pop(const glift::Device& device, const lists::NumberStack& stack, const lists::Numbers& to) {
    lists::pop_stack(device, stack, to);
}
void pop(const glift::Device& device, const lists::NumberQueue& queue, const lists::Numbers& to) {
    lists::pop_queue(device, queue, to);
}

template <class Container> void pushes_and_pops(const glift::Device& device, Round& round) {
    const Number capacity = round.below(600);
    Container found(device, capacity);
    std::deque<Number> model;
    Number refused = 0;
    for (int step = 0; step < 20 && !testing::Test::HasFailure(); ++step) {
        if (round.chance(2)) {
            const std::vector<Number> items = numbers(round, round.below(200));
            const std::size_t room = std::min<std::size_t>(items.size(), capacity - model.size());
            // From a kernel only where there is room for all: which invocations find room is unspecified.
            if (room == items.size() && round.chance(2)) {
                const std::vector<Number> same(items.size(), items.empty() ? 0 : items[0]);
                Ends<Container>::push(device, on_device(device, same), found);
                model.insert(model.end(), same.begin(), same.end());
            } else {
                found.push_all(device, on_device(device, items));
                model.insert(model.end(), items.begin(), items.begin() + static_cast<std::ptrdiff_t>(room));
                refused += static_cast<Number>(items.size() - room);
            }
        } else {
            const std::size_t asked = round.below(300), n = std::min(asked, model.size());
            const lists::Numbers to(device, static_cast<Number>(asked));
            pop(device, found, to);
            std::vector<Number> taken = Ends<Container>::take(model, n), popped = to.read();
            taken.resize(asked, nothing);
            std::ranges::sort(taken);
            std::ranges::sort(popped);
            ASSERT_TRUE(property::equal(round, taken, popped, "popped"));
        }
        ASSERT_EQ(found.size(device), model.size());
        ASSERT_EQ(found.refused(device), refused);
    }
}

TEST_P(Lists, Stacks) {
    for_all("stack", [&](Round& round) { pushes_and_pops<lists::NumberStack>(device(), round); });
}

TEST_P(Lists, Queues) {
    for_all("queue", [&](Round& round) { pushes_and_pops<lists::NumberQueue>(device(), round); });
}

}  // namespace
