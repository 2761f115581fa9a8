// Boxes of a structure's elements, copied to the host and written back.
#pragma once

#include <glift/api.h>
#include <glift/range.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace glift {

namespace detail {

[[noreturn]] GLIFT_API void throw_unmapped(const char* type, const char* operation);
/// Calls `write(mapped)`; an error is only logged.
GLIFT_API void write_back(const char* type, void (*write)(void* mapped), void* mapped) noexcept;

}  // namespace detail

/// A copy of a box of elements on the host, written back to the structure when it is unmapped or goes out of scope.
/// Keeps the structure's memory alive. An error of writing back is thrown by unmap(), but only logged (log.h) by the
/// destructor.
template <class S> class Mapped {
public:
    using Address = typename S::Address;
    using Element = typename S::Element;

    Mapped(const S& structure, Address origin, Address size)
        : structure_(structure), origin_(origin), size_(size), values_(structure.read(origin, size)) {}
    Mapped(Mapped&& other) noexcept
        : structure_(std::move(other.structure_)), origin_(other.origin_), size_(other.size_),
          values_(std::move(other.values_)), is_mapped_(std::exchange(other.is_mapped_, false)) {}
    Mapped& operator=(Mapped&&) = delete;
    ~Mapped() {
        detail::write_back(
            S::type_name, [](void* mapped) { static_cast<Mapped*>(mapped)->unmap(); }, this);
    }

    /// The address counts from the box's origin. Throws wrong_argument for an address outside the box. Both
    /// operator[] and values() also throw it after unmap(), and after the object was moved from.
    Element& operator[](Address address) {
        const Extent a = detail::extent_of(address, 0), n = detail::extent_of(size_);
        const detail::Box box{S::type_name, detail::Axes<Address>::count, a, {1, 1, 1, 1}, n};
        require_mapped("operator[]");
        if (!box.is_inside()) detail::throw_outside_mapped(box);
        return values_[((std::size_t{a[3]} * n[2] + a[2]) * n[1] + a[1]) * n[0] + a[0]];
    }
    std::span<Element> values() {
        require_mapped("values");
        return values_;
    }
    Address size() const { return size_; }

    void unmap() {
        if (std::exchange(is_mapped_, false)) structure_.write(origin_, size_, values_);
    }

private:
    void require_mapped(const char* operation) const {
        if (!is_mapped_) detail::throw_unmapped(S::type_name, operation);
    }

    S structure_;
    Address origin_, size_;
    std::vector<Element> values_;
    bool is_mapped_ = true;
};

}  // namespace glift
