// The arguments of one call of a kernel that draws.
#pragma once

#include <glift/commands.h>
#include <glift/drawing.h>
#include <glift/footprint.h>
#include <glift/iteration.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

namespace glift {

/// Corners (vertices), instances and targets of one call. Arguments are added one by one, in the kernel's order. Each
/// is checked as it is added: wrong_argument is thrown where it does not fit those before it, or its box lies outside
/// the domain.
class DrawIteration {
public:
    explicit DrawIteration(const Kernel& kernel) : kernel_(kernel) {}

    /// A range with an element for each corner. All such ranges must have one size.
    template <class S> void corners(const char* name, const Range<S>& range) {
        add_counted(0, detail::box_of(name, range), range.is_whole(), range.device_counts());
    }
    /// A range with an element for each instance. All such ranges must have one size.
    template <class S> void instances(const char* name, const Range<S>& range) {
        add_counted(1, detail::box_of(name, range), range.is_whole(), range.device_counts());
    }
    /// A range that is read or written at any address.
    template <class S> void any(const char* name, const Range<S>& range) {
        add_any(detail::box_of(name, range), range.is_whole());
    }
    /// A target: a range of an image, `memory`, that is drawn to. The texel of each element lies at the element's
    /// virtual address. All targets must have ranges of one size that begin at the same pixel.
    template <class S> void colour(const char* name, const Range<S>& range, const Memory& memory) {
        add_pixels(detail::box_of(name, range), range.is_whole(), range.device_counts());
        add_origin(detail::box_of(name, range));
        colours_.push_back({memory});
    }
    template <class S> void depth(const char* name, const Range<S>& range, const Memory& memory) {
        add_pixels(detail::box_of(name, range), range.is_whole(), range.device_counts());
        add_origin(detail::box_of(name, range));
        targets_.depth = {memory};
    }
    /// The range of an `at` parameter: the fragment shader gets the address of its pixel in this range. The range must
    /// have the targets' size.
    template <class S> void pixels(const char* name, const Range<S>& range) {
        add_pixels(detail::box_of(name, range), range.is_whole(), range.device_counts());
    }

    bool is_shared(std::span<const Memory> memories) const { return detail::is_shared(kernel_, memories); }
    void share(std::span<const Memory> memories, std::initializer_list<detail::Footprint> footprints) {
        sharing_ = detail::compare_footprints(kernel_, memories, axes_[0].box, footprints);
    }

    /// The numbers of corners and instances; upper bounds of those that the device computes.
    uint2 counts() const { return uint2(axes_[0].count(), axes_[1].count()); }
    /// Whether the call may take the kernel's direct form, as far as the ranges and the device are concerned: all
    /// ranges are whole structures, and Commands::can_be_direct.
    GLIFT_API bool can_be_direct(const Commands& commands, std::span<const Memory> memories) const;
    /// Dispatches the call with the parameter block of that form. `sizes` are the offsets of the numbers of corners and
    /// instances in it, which the device fills in if it computes them.
    GLIFT_API void dispatch(const Commands& commands, FormName form, std::span<const Memory> memories,
                            std::span<const std::byte> parameters, std::initializer_list<std::size_t> sizes = {});
    /// Adds patches for the size of a range that is read or written at any address, if the device computes it.
    template <class S> void count(const Range<S>& range, std::size_t offset) {
        add_patches(range.device_counts(), offset, detail::extent_of(range.size()),
                    detail::Axes<typename S::Address>::count);
    }

private:
    Extent size() const { return {axes_[0].count(), axes_[1].count(), 1, 1}; }
    /// An axis of the draw, of corners or of instances: its first range, and the device values that bound the length.
    struct Axis {
        detail::Box box{};
        bool is_given = false;
        std::vector<detail::DeviceCount> counts = {};
        std::uint32_t count() const { return is_given ? box.size[0] : 1; }
    };

    GLIFT_API void add_counted(std::size_t axis, const detail::Box& box, bool is_whole,
                               const std::vector<detail::DeviceCount>& counts);
    GLIFT_API void add_any(const detail::Box& box, bool is_whole);
    GLIFT_API void add_pixels(const detail::Box& box, bool is_whole, const std::vector<detail::DeviceCount>& counts);
    GLIFT_API void add_origin(const detail::Box& box);
    GLIFT_API void add_patches(const std::vector<detail::DeviceCount>& counts, std::size_t offset, const Extent& limits,
                               unsigned axes);

    const Kernel& kernel_;
    std::array<Axis, 2> axes_;
    detail::Box pixels_{};
    bool has_pixels_ = false, has_origin_ = false;
    bool whole_ = true;
    Sharing sharing_ = Sharing::unknown;
    std::vector<Attachment> colours_;
    DrawTargets targets_;
    std::vector<Patch> patches_;
};

}  // namespace glift
