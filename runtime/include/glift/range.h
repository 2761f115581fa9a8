// Boxes of a structure's elements, as objects that are passed to kernels, and single values that lie on the device.
#pragma once

#include <glift/box.h>
#include <glift/commands.h>

#include <cstring>
#include <utility>
#include <vector>

namespace glift {

/// A value that lies on the device: at byte `offset` of a buffer.
template <class T> struct DeviceScalar {
    Memory memory;
    std::uint64_t offset = 0;

    /// Brings the value to the host. Waits for all commands before it in the stream.
    T await(const Commands& commands) const {
        const Download download = commands.download(memory, offset, sizeof(T));
        T value;
        std::memcpy(&value, download.get().data(), sizeof(T));
        return value;
    }
    /// The value's index in its memory, counted in values of type T.
    uint index() const { return fitted(offset / sizeof(T), "index of a value on the device"); }
    operator DeviceValue() const { return {memory, offset}; }
};

namespace detail {

/// A box's size that is computed on the device. Along axis i it is the number at `value.offset + 4 * i` minus
/// `before[i]`, or 0 where that is negative: `value` is the size of a range, in which the box begins at `before`.
struct DeviceCount {
    DeviceValue value;
    Extent before{};

    bool operator==(const DeviceCount& other) const {
        return value.memory.object() == other.value.memory.object() && value.offset == other.value.offset &&
               before == other.before;
    }
};

}  // namespace detail

/// A box of a structure of type S, or the whole structure. Shares the structure's memory and keeps it alive.
template <class S> class Range {
public:
    using Address = typename S::Address;

    Range() = default;
    Range(const S& structure) : structure_(structure), size_(structure.domain()), whole_(true) {}
    Range(const S& structure, Address origin, Address size) : structure_(structure), origin_(origin), size_(size) {}
    /// The first elements from `origin` on along each axis: as many as a value on the device says, `size` at most.
    Range(const S& structure, Address origin, Address size, DeviceScalar<Address> count)
        : structure_(structure), origin_(origin), size_(size), counts_{{std::move(count), {}}} {}
    Range(const S& structure, Address origin, Address size, std::vector<detail::DeviceCount> counts)
        : structure_(structure), origin_(origin), size_(size), counts_(std::move(counts)) {}

    const S& structure() const { return structure_; }
    const S* operator->() const { return &structure_; }
    Address origin() const { return origin_; }
    Address size() const { return size_; }
    bool is_whole() const { return whole_; }
    /// Values on the device: along each axis the number of elements is the minimum of these and of `size()`. Empty
    /// where the host knows the number.
    const std::vector<detail::DeviceCount>& device_counts() const { return counts_; }

    /// A box within this range; `origin` counts from this range's origin. Throws wrong_argument where the box lies
    /// outside this range.
    Range range(Address origin, Address size) const {
        require_inside(origin, size);
        Range part(structure_, origin_ + origin, size);
        part.counts_ = counts_;
        const Extent first = detail::extent_of(origin, 0);
        for (detail::DeviceCount& count : part.counts_)
            for (unsigned i = 0; i < 4; ++i) count.before[i] += first[i];
        return part;
    }
    /// The first elements along each axis: as many as a value on the device says, and no more than there are.
    Range first(DeviceScalar<Address> count) const {
        Range part(structure_, origin_, size_);
        part.counts_ = counts_;
        part.counts_.push_back({std::move(count), {}});
        return part;
    }
    /// An element of the box, left on the device, as by Structure::element_in_place and Structure::element.
    auto element_in_place(const Commands& commands, Address address) const {
        require_inside(address, Address(1));
        return structure_.element_in_place(commands, origin_ + address);
    }
    auto element(const Commands& commands, Address address) const {
        require_inside(address, Address(1));
        return structure_.element(commands, origin_ + address);
    }
    /// Reads `size()` elements along each axis, whatever the device counts say. Waits as Structure::read does.
    std::vector<typename S::Element> read() const { return structure_.read(origin_, size_); }

private:
    void require_inside(Address origin, Address size) const {
        const detail::Box box{S::type_name, detail::Axes<Address>::count, detail::extent_of(origin, 0),
                              detail::extent_of(size), detail::extent_of(size_)};
        if (!box.is_inside()) detail::throw_outside_range(S::type_name, box);
    }

    S structure_;
    Address origin_{};
    Address size_{};
    std::vector<detail::DeviceCount> counts_;
    bool whole_ = false;
};

namespace detail {

template <class S> typename S::Address size_of(const S& structure) { return structure.domain(); }
template <class S> typename S::Address size_of(const Range<S>& range) { return range.size(); }

}  // namespace detail

/// The box [first, last), which pipelines write a[first .. last]. `place` is the source location, for errors. Throws
/// wrong_argument unless first <= last <= size along each axis.
template <class S> auto slice(const S& from, typename S::Address first, typename S::Address last, const char* place) {
    const Extent begin = detail::extent_of(first, 0), end = detail::extent_of(last, 0);
    const Extent whole = detail::extent_of(detail::size_of(from));
    constexpr unsigned rank = detail::Axes<typename S::Address>::count;
    for (unsigned axis = 0; axis < rank; ++axis)
        if (begin[axis] > end[axis] || end[axis] > whole[axis]) detail::throw_slice(place, rank, begin, end, whole);
    return from.range(first, last - first);
}

/// How many elements a structure or a box has; throws too_large where the number does not fit a uint.
template <class S> uint element_count(const S& structure) {
    return fitted(detail::volume_of(detail::extent_of(detail::size_of(structure))), "count of a structure's elements");
}

}  // namespace glift
