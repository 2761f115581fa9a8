// A model on the host of the pages of quadtrees and octrees: their numbers, and which of them are resident.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace model {

using Number = std::uint32_t;

template <int N> using Place = std::array<Number, N>;

/// The entries of a table, with 0 in place of those whose own page is not resident. Such an entry names a coarser page,
/// and says in the bits from 27 on how many levels coarser that page is.
inline std::vector<Number> own(std::vector<Number> entries) {
    for (Number& entry : entries)
        if (entry >> 27 != 0) entry = 0;
    return entries;
}

/// A set of pages of a tree. Level 0 is the finest.
template <int N> class Tree {
public:
    struct Page {
        Number level;
        Place<N> at;
        auto operator<=>(const Page&) const = default;
    };

    explicit Tree(Number levels) : levels_(levels) {}

    Number levels() const { return levels_; }
    Number along(Number level) const { return 1U << (levels_ - 1 - level); }
    const std::set<Page>& pages() const { return pages_; }
    void put(const Page& page) { pages_.insert(page); }
    void clear() { pages_.clear(); }

    /// Numbers of pages count from the coarsest level on, and row by row within a level.
    Number number_of(const Page& page) const {
        Number first = 0, number = 0;
        for (Number level = levels_ - 1; level > page.level; --level) first += pages_of(level);
        for (int axis = N; axis-- > 0;) number = number * along(page.level) + page.at[axis];
        return first + number;
    }
    Page page_of(Number number) const {
        Page page{levels_ - 1, {}};
        for (; number >= pages_of(page.level); --page.level) number -= pages_of(page.level);
        for (int axis = 0; axis < N; ++axis, number /= along(page.level)) page.at[axis] = number % along(page.level);
        return page;
    }
    Number count() const {
        Number all = 0;
        for (Number level = 0; level < levels_; ++level) all += pages_of(level);
        return all;
    }

    /// Reduces the set to at most `most` pages, as the policy `coarsen` does: level by level, from the finest on, pages
    /// are replaced by their parents until the set is small enough; then pages of the level that was replaced last are
    /// put back, the lowest numbers first, until the set has `most` pages.
    void coarsen(Number most) {
        std::map<Number, Page> gone;
        for (Number level = 0; level + 1 < levels_ && pages_.size() > most; ++level) {
            std::set<Page> raised;
            gone.clear();
            for (Page page : pages_) {
                if (page.level == level) {
                    gone[number_of(page)] = page;
                    page = parent_of(page);
                }
                raised.insert(page);
            }
            pages_ = std::move(raised);
        }
        for (const auto& [number, page] : gone)
            if (pages_.size() < most) pages_.insert(page);
    }

    /// The page itself or the finest coarser one that there is; null: there is none.
    const Page* find(Page page) const {
        for (;; page = parent_of(page)) {
            if (const auto found = pages_.find(page); found != pages_.end()) return &*found;
            if (page.level + 1 == levels_) return nullptr;
        }
    }

private:
    static Page parent_of(Page page) {
        ++page.level;
        for (Number& at : page.at) at /= 2;
        return page;
    }
    Number pages_of(Number level) const { return 1U << N * (levels_ - 1 - level); }

    Number levels_;
    std::set<Page> pages_;
};

}  // namespace model
