// What one call of a kernel visits.
#pragma once

#include <glift/footprint.h>
#include <glift/range.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace glift {

/// The elements that one call of a kernel visits, checked while its arguments are looked at one by one.
class Iteration {
public:
    explicit Iteration(const Kernel& kernel) : kernel_(kernel) {}

    /// A range that is visited element by element. All such ranges have one size.
    template <class S> void each(const char* name, const Range<S>& range) {
        const detail::Box box = box_of(name, range.origin(), range);
        if (!box.is_inside()) detail::throw_outside(where(), box);
        if (count_ == 0) first_ = box;
        else if (box.size != first_.size) throw_sizes(first_, box);
        ++count_;
        whole_ = whole_ && range.is_whole();
        for (const detail::DeviceCount& count : range.device_counts())
            if (std::ranges::find(counts_, count) == counts_.end()) counts_.push_back(count);
    }

    /// A range that is looked at around the current element. A whole structure follows the first visited range; a box
    /// has its own origin and the same size.
    template <class S> void near(const char* name, const Range<S>& range) {
        detail::Box box = box_of(name, range.origin(), range);
        if (range.is_whole()) {
            box.origin = first_.origin;
            box.size = first_.size;
            if (!box.is_inside()) throw_small(first_, box);
        } else if (box.size != first_.size) {
            throw_sizes(first_, box);
        }
        if (!box.is_inside()) detail::throw_outside(where(), box);
        whole_ = whole_ && range.is_whole() && box.origin == Extent{} && box.size == box.domain;
    }

    /// A range that is read or written anywhere.
    template <class S> void any(const char* name, const Range<S>& range) {
        const detail::Box box = box_of(name, range.origin(), range);
        if (!range.is_whole() && !box.is_inside()) detail::throw_outside(where(), box);
        whole_ = whole_ && range.is_whole();
    }

    /// The first address that `near` looks around.
    template <class S> typename S::Address centre(const Range<S>& range) const {
        if (!range.is_whole()) return range.origin();
        typename S::Address origin{};
        if constexpr (detail::Axes<typename S::Address>::count == 1) origin = first_.origin[0];
        else
            for (unsigned i = 0; i < detail::Axes<typename S::Address>::count; ++i) origin[i] = first_.origin[i];
        return origin;
    }

    /// Whether some memory stands for two parameters and is written: then `share` says how.
    bool is_shared(std::span<const Memory> memories) const { return detail::is_shared(kernel_, memories); }
    /// The ranges of all structures that the kernel takes, in its order. Throws where invocations could meet.
    void share(std::span<const Memory> memories, std::initializer_list<detail::Footprint> footprints) {
        sharing_ = detail::compare_footprints(kernel_, memories, first_, footprints);
    }
    Sharing sharing() const { return sharing_; }

    const Extent& size() const { return first_.size; }
    /// All ranges are whole structures.
    bool is_whole() const { return whole_; }
    /// What to write into the parameters where a size comes from the device: the iteration's, at `offsets`.
    std::span<const Patch> patches(std::initializer_list<std::size_t> offsets) {
        for (std::size_t offset : offsets) patch(counts_, offset, first_.size, first_.rank);
        return {patches_.data(), patch_count_};
    }
    /// The same for the size of a range that is read or written anywhere. Before `patches`.
    template <class S> void count(const Range<S>& range, std::size_t offset) {
        patch(range.device_counts(), offset, detail::extent_of(range.size()), detail::Axes<typename S::Address>::count);
    }

private:
    template <class S>
    static detail::Box box_of(const char* name, const typename S::Address& origin, const Range<S>& range) {
        return {name, detail::Axes<typename S::Address>::count, detail::extent_of(origin, 0),
                detail::extent_of(range.size()), detail::extent_of(range->domain())};
    }
    std::string where() const {
        return std::string(kernel_.file) + ":" + std::to_string(kernel_.line) + ": " + kernel_.name;
    }
    [[noreturn]] void throw_sizes(const detail::Box& a, const detail::Box& b) const {
        throw Error(ErrorCode::wrong_argument, "ranges of different sizes", where(),
                    a.name + (" is " + detail::text_of(a.size, a.rank)) + " and " + b.name + " is " +
                        detail::text_of(b.size, b.rank),
                    "pass ranges of one size: all of each structure, or boxes made with range(origin, size)");
    }

    [[noreturn]] void throw_small(const detail::Box& visited, const detail::Box& around) const {
        throw Error(ErrorCode::wrong_argument, "structures of different sizes", where(),
                    std::string("the domain of ") + around.name + " is " + detail::text_of(around.domain, around.rank) +
                        ", too small to look around what is visited: " + visited.name + ", " +
                        detail::text_of(visited.size, visited.rank) + " from " +
                        detail::text_of(visited.origin, visited.rank) + " on",
                    "pass structures of one size, or boxes of one size made with range(origin, size)");
    }

    /// A word for each axis.
    void patch(const std::vector<detail::DeviceCount>& counts, std::size_t offset, const Extent& limits,
               unsigned axes) {
        if (patch_count_ + axes * counts.size() > patches_.size())
            throw Error(ErrorCode::wrong_argument, "too many sizes that live on the device", where(),
                        "one call takes " + std::to_string(patches_.size()) + " numbers", "split the kernel");
        for (unsigned axis = 0; axis < axes; ++axis)
            for (const detail::DeviceCount& count : counts)
                patches_[patch_count_++] = {{count.value.memory, count.value.offset + 4 * axis},
                                            static_cast<std::uint32_t>(offset + 4 * axis),
                                            limits[axis],
                                            count.before[axis],
                                            &count != counts.data()};
    }

    const Kernel& kernel_;
    detail::Box first_{};
    unsigned count_ = 0;
    bool whole_ = true;
    Sharing sharing_ = Sharing::unknown;
    std::vector<detail::DeviceCount> counts_;  ///< of what is visited
    std::array<Patch, 24> patches_{};
    std::size_t patch_count_ = 0;
};

/// A parameter block as bytes. There are two types of blocks a kernel: std::as_bytes would take longer to compile for
/// them than all else of the call.
template <class T> std::span<const std::byte> bytes_of(const T& value) {
    return {reinterpret_cast<const std::byte*>(&value), sizeof value};
}

}  // namespace glift
