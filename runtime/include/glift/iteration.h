// What one call of a kernel visits.
#pragma once

#include <glift/commands.h>
#include <glift/footprint.h>
#include <glift/range.h>
#include <glift/range_shape.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace glift {

/// The elements that one call of a kernel visits. Arguments are added one by one, and each is checked as it is added:
/// wrong_argument is thrown where it does not fit those before it, or its box lies outside the domain. What does not
/// depend on a structure's type is not inline, since programs have many calls.
class Iteration {
public:
    explicit Iteration(const Kernel& kernel) : kernel_(kernel) {}

    /// A range that is visited element by element. All such ranges must have one size.
    template <class S> void each(const char* name, const Range<S>& range) {
        note(name, &range, &detail::shape_of<S>);
        add_visited(detail::box_of(name, range), range.is_whole(), range.device_counts());
    }
    /// A range that is read in a window around the current element. In a whole structure the windows lie around the
    /// addresses of the first visited range; a box has an origin of its own, and must have that range's size.
    template <class S> void near(const char* name, const Range<S>& range) {
        note(name, &range, &detail::shape_of<S>);
        add_near(detail::box_of(name, range), range.is_whole());
    }
    /// A range that is read or written at any address.
    template <class S> void any(const char* name, const Range<S>& range) {
        add_any(detail::box_of(name, range), range.is_whole());
    }

    /// For a kernel over the blocks of a structure (docs/reference/language.md, Blocks): it visits {elements of a
    /// block, number of blocks} of the first range. If the device computes the number of blocks, that is `count`, and
    /// `visited.y` is an upper bound of it.
    void blocks(uint2 visited) {
        visited_ = visited;
        if (visited_.x == 0 || visited_.y == 0) visited_ = {0, 0};
    }
    void blocks(uint2 visited, const DeviceScalar<uint>& count) {
        blocks(visited);
        block_count_ = count;
    }
    /// Throws wrong_argument if two structures that are visited block by block may have different blocks. Each pair
    /// holds a memory that the blocks of `first` are read from and that of `other`: they must be the same.
    GLIFT_API void same_blocks(const char* first, const char* other,
                               std::initializer_list<std::pair<Memory, Memory>> memories) const;
    uint2 visited() const { return visited_; }
    /// Adds a patch (pass.h) that writes the number of blocks into the iteration's size at `offset`, if the device
    /// computes it.
    GLIFT_API void count_blocks(std::size_t offset);

    /// The address in the range's structure at which the first invocation's `near` window is centred.
    template <class S> typename S::Address centre(const Range<S>& range) const {
        if (!range.is_whole()) return range.origin();
        typename S::Address origin{};
        if constexpr (detail::Axes<typename S::Address>::count == 1) origin = first_.origin[0];
        else
            for (unsigned i = 0; i < detail::Axes<typename S::Address>::count; ++i) origin[i] = first_.origin[i];
        return origin;
    }

    /// Whether one memory is bound twice and written: then `share` must be called.
    bool is_shared(std::span<const Memory> memories) const { return detail::is_shared(kernel_, memories); }
    /// Sets `sharing` from the footprints of all parameters that are structures or values on the device, in the
    /// kernel's order. Throws aliased_memory where it cannot rule out that invocations race.
    void share(std::span<const Memory> memories, std::initializer_list<detail::Footprint> footprints) {
        sharing_ = detail::compare_footprints(kernel_, memories, first_, footprints);
    }
    /// Whether the call may take the kernel's direct form, as far as the ranges and the device are concerned: all
    /// ranges are whole structures, those of `near` have the size of the visited ones, and Commands::can_be_direct.
    GLIFT_API bool can_be_direct(const Commands& commands, std::span<const Memory> memories) const;
    /// The memory in which the parts of sums meet (Kernel::sums), for this call. Throws too_large where they take 2^32
    /// words or more.
    GLIFT_API Memory partial_sums(const Commands& commands) const;
    /// Dispatches the call with the parameter block of that form. `sizes` are the offsets of the iteration's size in
    /// it, which the device fills in if it computes the size.
    GLIFT_API void dispatch(const Commands& commands, FormName form, std::span<const Memory> memories,
                            std::span<const std::byte> parameters, std::initializer_list<std::size_t> sizes = {});
    /// Adds patches for the size of a range that is read or written at any address, if the device computes it.
    template <class S> void count(const Range<S>& range, std::size_t offset) {
        if (!range.device_counts().empty())
            patch(range.device_counts(), offset, detail::extent_of(range.size()),
                  detail::Axes<typename S::Address>::count);
    }

private:
    /// {elements of a block, blocks} in kernels over blocks, else the size of the first visited range.
    Extent size() const;
    GLIFT_API void add_visited(const detail::Box& box, bool is_whole, const std::vector<detail::DeviceCount>& counts);
    GLIFT_API void add_near(detail::Box box, bool is_whole);
    GLIFT_API void add_any(const detail::Box& box, bool is_whole);
    [[noreturn]] GLIFT_API void throw_patches() const;
    GLIFT_API void patch(const std::vector<detail::DeviceCount>& counts, std::size_t offset, const Extent& limits,
                         unsigned axes);

    void note(const char* name, const void* range, detail::RangeShape (*shape)(const void*)) {
        if (visited_count_ < visited_ranges_.size()) visited_ranges_[visited_count_] = {name, range, shape};
        ++visited_count_;
    }

    const Kernel& kernel_;
    detail::Box first_{};
    unsigned count_ = 0;
    bool are_counted_ = false;  ///< all ranges visited so far have a length on the device
    bool whole_ = true;
    Sharing sharing_ = Sharing::unknown;
    std::vector<detail::DeviceCount> counts_;  ///< device values that bound the size of the visited ranges
    uint2 visited_{0, 0};
    std::optional<DeviceValue> block_count_;
    std::array<Patch, 24> patches_{};
    std::size_t patch_count_ = 0;
    std::array<detail::VisitedRange, 12> visited_ranges_;
    std::size_t visited_count_ = 0;  ///< more than there is room for: the ranges are not known
};

/// A parameter block as bytes. Not std::as_bytes, since compiling that for every kernel's types of parameter blocks
/// takes longer.
template <class T> std::span<const std::byte> bytes_of(const T& value) {
    return {reinterpret_cast<const std::byte*>(&value), sizeof value};
}

}  // namespace glift
