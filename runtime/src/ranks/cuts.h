// Which rank owns which planes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glift::detail {

/// Consecutive planes [first, end).
struct Planes {
    std::uint32_t first = 0, end = 0;

    std::uint32_t count() const { return end > first ? end - first : 0; }
    bool operator==(const Planes&) const = default;
};

/// Rank r owns the planes [cuts[r], cuts[r + 1]).
class Cuts {
public:
    /// Equal parts; the boundaries are multiples of eight, so that they lie between workgroups, where the parts have at
    /// least 32 planes.
    Cuts(std::uint32_t planes, unsigned ranks);
    /// Parts of about equal weight; `before[k]` is the weight of all planes before plane k, up to k = number of planes.
    Cuts(std::span<const std::uint64_t> before, unsigned ranks);

    unsigned ranks() const { return static_cast<unsigned>(cuts_.size() - 1); }
    std::uint32_t planes() const { return cuts_.back(); }
    Planes of(unsigned rank) const { return {cuts_[rank], cuts_[rank + 1]}; }
    unsigned owner(std::uint32_t plane) const;
    bool operator==(const Cuts&) const = default;

private:
    std::vector<std::uint32_t> cuts_;
};

}  // namespace glift::detail
