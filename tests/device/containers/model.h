// A model on the host of the page pools of sparse arrays and adaptive trees: which page has which frame.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

namespace model {

using Number = std::uint32_t;

enum class Overflow { fail, drop, evict, grow };

struct Status {
    Number requested = 0, granted = 0, refused = 0, resident = 0, capacity = 0;
    bool operator==(const Status&) const = default;
};

/// The pages of a pool, by their numbers below `bound`: requests, grants and releases under a policy for full pools.
class Pages {
public:
    Pages(Overflow policy, Number bound, Number capacity) : policy_(policy), bound_(bound) {
        status_.capacity = capacity;
    }

    void request(Number page) {
        if (page < bound_) wanted_.insert(page);
    }
    void release(Number page) {
        if (page < bound_) unwanted_.insert(page);
    }

    /// Makes the change that was requested; if `releases_others`, pages that were not requested are released. Returns
    /// the numbers of the pages that were granted, ascending.
    std::vector<Number> change(bool releases_others) {
        ++round_;
        std::vector<Number> missing, gone;
        for (Number page : wanted_) {
            if (const auto at = frames_.find(page); at == frames_.end()) missing.push_back(page);
            else if (policy_ == Overflow::evict) used_[at->first] = round_;
        }
        for (const auto& [page, frame] : frames_)
            if ((releases_others || unwanted_.contains(page)) && !wanted_.contains(page)) gone.push_back(page);
        take_back(gone);
        const auto requested = static_cast<Number>(missing.size());
        if (policy_ == Overflow::evict && requested > room()) take_back(oldest(requested - room()));
        if (policy_ == Overflow::grow && requested > room())
            status_.capacity = std::max(2 * status_.capacity, requested + resident());
        if (policy_ == Overflow::fail && requested > room()) missing.clear();
        missing.resize(std::min<std::size_t>(missing.size(), room()));
        for (Number page : missing) {
            frames_[page] = free_.empty() ? next_++ : free_.back();
            if (!free_.empty()) free_.pop_back();
            used_[page] = round_;
        }
        wanted_.clear();
        unwanted_.clear();
        const auto granted = static_cast<Number>(missing.size());
        status_ = {requested, granted, requested - granted, resident(), status_.capacity};
        return missing;
    }

    /// Moves pages out of frames beyond the first resident() ones into free ones. Returns {from: to}.
    std::map<Number, Number> compact() {
        std::map<Number, Number> moves;
        std::set<Number> holes;
        for (Number frame = 0; frame < resident(); ++frame) holes.insert(frame);
        for (const auto& [page, frame] : frames_) holes.erase(frame);
        for (auto& [page, frame] : frames_) {
            if (frame < resident()) continue;
            moves[frame] = *holes.begin();
            frame = *holes.begin();
            holes.erase(holes.begin());
        }
        free_.clear();
        next_ = resident();
        return moves;
    }

    Number bound() const { return bound_; }
    const Status& status() const { return status_; }
    const std::map<Number, Number>& frames() const { return frames_; }
    const std::vector<Number>& free() const { return free_; }
    /// The change, counted from 1, in which a resident page was granted or, if the policy evicts, last requested.
    Number used(Number page) const { return used_.at(page); }

private:
    Number resident() const { return static_cast<Number>(frames_.size()); }
    Number room() const { return status_.capacity - resident(); }

    void take_back(const std::vector<Number>& ascending) {
        for (auto page = ascending.rbegin(); page != ascending.rend(); ++page) {
            free_.push_back(frames_.at(*page));
            frames_.erase(*page);
        }
    }

    /// The n pages that were not requested in this round and were requested longest ago, ascending.
    std::vector<Number> oldest(Number n) const {
        std::vector<std::pair<Number, Number>> ages;
        for (const auto& [page, frame] : frames_)
            if (used_.at(page) != round_) ages.emplace_back(used_.at(page), page);
        std::ranges::sort(ages);
        ages.resize(std::min<std::size_t>(ages.size(), n));
        std::vector<Number> pages;
        for (const auto& [age, page] : ages) pages.push_back(page);
        std::ranges::sort(pages);
        return pages;
    }

    Overflow policy_;
    Number bound_;
    Number round_ = 0, next_ = 0;  ///< next_: since the last `compact` neither this frame nor a later one was used
    Status status_;
    std::map<Number, Number> frames_;
    std::unordered_map<Number, Number> used_;
    std::vector<Number> free_;
    std::set<Number> wanted_, unwanted_;
};

}  // namespace model
