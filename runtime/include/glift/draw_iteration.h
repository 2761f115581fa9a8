// What one call of a kernel that draws is given.
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

/// Corners, instances and targets of one call. Arguments are added and checked one by one, in the kernel's order.
class DrawIteration {
public:
    explicit DrawIteration(const Kernel& kernel) : kernel_(kernel) {}

    /// A range with an element for each corner. All such ranges have one size.
    template <class S> void corners(const char* name, const Range<S>& range) {
        add_counted(0, detail::box_of(name, range), range.is_whole(), range.device_counts());
    }
    /// The same for instances.
    template <class S> void instances(const char* name, const Range<S>& range) {
        add_counted(1, detail::box_of(name, range), range.is_whole(), range.device_counts());
    }
    /// A range that is read or written anywhere.
    template <class S> void any(const char* name, const Range<S>& range) {
        add_any(detail::box_of(name, range), range.is_whole());
    }
    /// What is drawn to: all targets have the same pixels. Elements of the range lie in `memory` where they are.
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
    /// A range whose addresses fragments see, of as many pixels.
    template <class S> void pixels(const char* name, const Range<S>& range) {
        add_pixels(detail::box_of(name, range), range.is_whole(), range.device_counts());
    }

    bool is_shared(std::span<const Memory> memories) const { return detail::is_shared(kernel_, memories); }
    void share(std::span<const Memory> memories, std::initializer_list<detail::Footprint> footprints) {
        sharing_ = detail::compare_footprints(kernel_, memories, axes_[0].box, footprints);
    }
    Sharing sharing() const { return sharing_; }

    /// Corners and instances.
    uint2 counts() const { return uint2(axes_[0].count(), axes_[1].count()); }
    Extent size() const { return {axes_[0].count(), axes_[1].count(), 1, 1}; }
    /// All ranges are whole structures.
    bool is_whole() const { return whole_; }
    const DrawTargets* targets() {
        targets_.colours = colours_;
        return &targets_;
    }

    /// Patches that write the counts into the parameters at the offset, where they come from the device.
    GLIFT_API std::span<const Patch> patches(std::initializer_list<std::size_t> offsets);
    /// The same for the size of a range that is read or written anywhere.
    template <class S> void count(const Range<S>& range, std::size_t offset) {
        add_patches(range.device_counts(), offset, detail::extent_of(range.size()),
                    detail::Axes<typename S::Address>::count);
    }

private:
    /// What is counted along an axis of the draw.
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
