// Boxes of a structure with blocks, such as a sparse grid, whose elements come to the host where it accesses them.
#pragma once

#include <glift/mapped.h>

#include <cstring>
#include <type_traits>
#include <unordered_map>

namespace glift {

namespace detail {

/// Structures with blocks: the elements of a few parts of a large domain are resident.
template <class S>
concept HasBlocks = requires {
    requires S::has_blocks;
};

/// The sides of the parts in which a mapped box moves: 4,096 elements each.
template <unsigned N> inline constexpr std::uint32_t mapped_side = N == 1 ? 4096 : N == 2 ? 64 : N == 3 ? 16 : 8;

}  // namespace detail

/// A box of a structure with blocks, mapped to the host. It moves in parts of 4,096 elements: a part is read when one
/// of its elements is first accessed, which waits for the device, and the parts that changed are written back by
/// unmap() or the destructor. So its time and memory follow what is accessed, however large the box is. Elements are
/// those of the structure when their part is read. Writes to elements that are not resident are lost. Keeps the
/// structure's memory alive. An error of writing back is thrown by unmap(), but only logged (log.h) by the destructor.
/// To go through all resident elements, read_resident() is faster. One thread at a time may use it.
template <class S> class MappedBlocks {
public:
    using Address = typename S::Address;
    using Element = typename S::Element;
    static_assert(std::is_trivially_copyable_v<Element>);

    MappedBlocks(const S& structure, Address origin, Address size)
        : structure_(structure), origin_(origin), size_(size) {}
    MappedBlocks(MappedBlocks&& other) noexcept
        : structure_(std::move(other.structure_)), origin_(other.origin_), size_(other.size_),
          parts_(std::move(other.parts_)), last_(std::exchange(other.last_, nullptr)),
          is_mapped_(std::exchange(other.is_mapped_, false)) {}
    MappedBlocks& operator=(MappedBlocks&&) = delete;
    ~MappedBlocks() {
        detail::write_back(
            S::type_name, [](void* mapped) { static_cast<MappedBlocks*>(mapped)->unmap(); }, this);
    }

    /// The address counts from the box's origin. Throws wrong_argument for an address outside the box, after unmap(),
    /// and after the object was moved from. The reference is valid until then.
    Element& operator[](Address address) {
        const Extent a = detail::extent_of(address, 0), n = detail::extent_of(size_);
        const detail::Box box{S::type_name, rank, a, {1, 1, 1, 1}, n};
        if (!is_mapped_) detail::throw_unmapped(S::type_name, "operator[]");
        if (!box.is_inside()) detail::throw_outside_mapped(box);
        Part& part = part_of(a, n);
        std::size_t at = 0;
        for (unsigned axis = rank; axis-- > 0;) at = at * part.extent[axis] + a[axis] % side;
        return part.values[at];
    }
    Address size() const { return size_; }

    void unmap() {
        if (!std::exchange(is_mapped_, false)) return;
        const auto parts = std::move(parts_);
        for (const auto& [number, part] : parts) {
            const std::size_t bytes = part.values.size() * sizeof(Element);
            if (std::memcmp(part.values.data(), part.before.data(), bytes) != 0)
                structure_.write(part.origin, part.size, part.values);
        }
    }

private:
    static constexpr unsigned rank = detail::Axes<Address>::count;
    static constexpr std::uint32_t side = detail::mapped_side<rank>;

    struct Part {
        std::uint64_t number;
        Address origin, size;
        Extent extent;
        std::vector<Element> values, before;
    };

    /// The part with this address in it, which is read if it was not yet. The last one is looked at first.
    Part& part_of(const Extent& address, const Extent& box) {
        std::uint64_t number = 0;
        for (unsigned axis = rank; axis-- > 0;) number = number * (box[axis] / side + 1) + address[axis] / side;
        if (last_ && last_->number == number) return *last_;
        auto found = parts_.find(number);
        if (found == parts_.end()) found = parts_.emplace(number, read(number, address, box)).first;
        return *(last_ = &found->second);
    }

    Part read(std::uint64_t number, const Extent& address, const Extent& box) const {
        Part part{
            .number = number, .origin = origin_, .size = size_, .extent = {1, 1, 1, 1}, .values = {}, .before = {}};
        for (unsigned axis = 0; axis < rank; ++axis) {
            const std::uint32_t first = address[axis] / side * side;
            part.extent[axis] = std::min(side, box[axis] - first);
            axis_of(part.origin, axis) += first;
            axis_of(part.size, axis) = part.extent[axis];
        }
        part.values = structure_.read(part.origin, part.size);
        part.before = part.values;
        return part;
    }

    static std::uint32_t& axis_of(Address& address, unsigned axis) {
        if constexpr (rank == 1) return address;
        else return address[axis];
    }

    S structure_;
    Address origin_, size_;
    std::unordered_map<std::uint64_t, Part> parts_;
    Part* last_ = nullptr;  ///< the part that was accessed last
    bool is_mapped_ = true;
};

}  // namespace glift
