// The resident elements of a structure, also said to `be there`: those whose addresses are mapped to memory, for
// example the elements of resident pages.
#pragma once

#include <glift/range.h>

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace glift {

/// An element of a Resident. `value` refers to its list.
template <class A, class T> struct ResidentElement {
    A address;
    T& value;
};

namespace detail {

/// A random-access iterator over the elements of a Resident. T is const where the lists are.
template <class A, class T> class ResidentIterator {
public:
    using value_type = ResidentElement<A, T>;
    using difference_type = std::ptrdiff_t;
    using iterator_concept = std::random_access_iterator_tag;

    ResidentIterator() = default;
    ResidentIterator(const A* address, T* value) : address_(address), value_(value) {}

    value_type operator*() const { return {*address_, *value_}; }
    value_type operator[](difference_type n) const { return *(*this + n); }
    ResidentIterator& operator+=(difference_type n) { return address_ += n, value_ += n, *this; }
    ResidentIterator& operator-=(difference_type n) { return *this += -n; }
    ResidentIterator& operator++() { return *this += 1; }
    ResidentIterator& operator--() { return *this -= 1; }
    ResidentIterator operator++(int) { return std::exchange(*this, *this + 1); }
    ResidentIterator operator--(int) { return std::exchange(*this, *this - 1); }
    friend ResidentIterator operator+(ResidentIterator it, difference_type n) { return it += n; }
    friend ResidentIterator operator+(difference_type n, ResidentIterator it) { return it += n; }
    friend ResidentIterator operator-(ResidentIterator it, difference_type n) { return it -= n; }
    friend difference_type operator-(const ResidentIterator& a, const ResidentIterator& b) {
        return a.value_ - b.value_;
    }
    friend bool operator==(const ResidentIterator& a, const ResidentIterator& b) { return a.value_ == b.value_; }
    friend auto operator<=>(const ResidentIterator& a, const ResidentIterator& b) { return a.value_ <=> b.value_; }

private:
    const A* address_ = nullptr;
    T* value_ = nullptr;
};

}  // namespace detail

/// Resident elements, in the order of their addresses, x running fastest. Entries i of the lists belong to one element.
/// It is a random-access range of ResidentElements: `for (const auto& [address, value] : grid.read_resident())`.
template <class A, class P, class T> struct Resident {
    std::vector<A> addresses;
    /// The physical addresses in the structure's own memory that `addresses` are translated to; empty for structures
    /// without a `list` (HasList), whose elements are always all resident.
    std::vector<P> places;
    std::vector<T> values;

    std::size_t size() const { return addresses.size(); }
    bool empty() const { return addresses.empty(); }

    auto begin() { return detail::ResidentIterator<A, T>(addresses.data(), values.data()); }
    auto end() { return begin() + static_cast<std::ptrdiff_t>(size()); }
    auto begin() const { return detail::ResidentIterator<A, const T>(addresses.data(), values.data()); }
    auto end() const { return begin() + static_cast<std::ptrdiff_t>(size()); }
};

namespace detail {

[[noreturn]] GLIFT_API void throw_not_searched(const char* type, std::uint64_t elements);

/// The most addresses that are looked at one by one: about a minute at 1 ns per address. For more, `resident` throws
/// too_large, unless the structure has blocks, whose elements alone are looked at.
inline constexpr std::uint64_t most_searched = std::uint64_t{1} << 36;

/// Structures with blocks, and those in which not every address is known to have an element of its own: some translator
/// is partial, or is neither @one_to_one nor has `invert`. Their member `list` runs a kernel that lists the resident
/// elements; `Place` is the type of an address in their own memory.
template <class S>
concept HasList = requires {
    typename S::Place;
};

template <class S> struct PlaceOf { using type = typename S::Address; };
template <HasList S> struct PlaceOf<S> { using type = typename S::Place; };

template <class S> using ResidentOf = Resident<typename S::Address, typename PlaceOf<S>::type, typename S::Element>;

/// Whether address a comes before address b in row-major order.
template <class A> bool comes_before(const A& a, const A& b) {
    const Extent first = extent_of(a, 0), second = extent_of(b, 0);
    return std::lexicographical_compare(first.rbegin(), first.rend(), second.rbegin(), second.rend());
}

/// A list in the device's memory, which a kernel fills.
template <class T> class ListedValues {
public:
    ListedValues(const Commands& commands, std::uint32_t entries) : entries_(entries) {
        memory = commands.allocate(
            {.name = "list", .bytes = (std::max<std::uint64_t>(entries, 1) * sizeof(T) + 3) / 4 * 4, .zeroed = false});
    }
    std::vector<T> read(const Commands& commands) const {
        std::vector<T> values(entries_);
        if (values.empty()) return values;
        const Download download = commands.download(memory, 0, entries_ * sizeof(T));
        std::memcpy(values.data(), download.get().data(), entries_ * sizeof(T));
        return values;
    }
    Memory memory;

private:
    std::uint32_t entries_;
};

/// Writes the resident elements of the range to lists on the device that have room for `most` entries. Returns the
/// number of resident elements; if that is `most`, copies the lists to `found` on the host.
template <class S>
std::uint32_t list(const Range<S>& range, const Commands& commands, std::uint32_t most, ResidentOf<S>& found) {
    const Memory counter = commands.allocate({.name = "counter", .bytes = 4});
    const ListedValues<typename S::Address> addresses(commands, most);
    const ListedValues<typename S::Place> places(commands, most);
    const ListedValues<typename S::Element> values(commands, most);
    range->list(commands, range, most, counter, addresses.memory, places.memory, values.memory);
    const std::uint32_t entries = DeviceScalar<std::uint32_t>{counter, 0}.await(commands);
    if (entries != most) return entries;
    found = {addresses.read(commands), places.read(commands), values.read(commands)};
    return entries;
}

template <class T> std::vector<T> in_order(const std::vector<T>& values, const std::vector<std::uint32_t>& order) {
    std::vector<T> sorted;
    sorted.reserve(values.size());
    for (std::uint32_t i : order) sorted.push_back(values[i]);
    return sorted;
}

/// The resident elements of a box, sorted by address. One pass counts them, another one lists them.
template <class S> ResidentOf<S> resident(const Range<S>& range, const Commands& commands) {
    const std::uint64_t searched = volume_of(extent_of(range.size()));
    if (!S::has_blocks && searched > most_searched) throw_not_searched(S::type_name, searched);
    ResidentOf<S> found;
    if (searched == 0) return found;
    std::uint32_t entries = list(range, commands, 0, found);
    // Repeated while the number changes in between, which happens where another thread writes to the structure.
    for (std::uint32_t most = 0; most != entries;) {
        most = entries;
        entries = list(range, commands, most, found);
    }
    std::vector<std::uint32_t> order(found.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(
        order, [&](std::uint32_t a, std::uint32_t b) { return comes_before(found.addresses[a], found.addresses[b]); });
    return {in_order(found.addresses, order), in_order(found.places, order), in_order(found.values, order)};
}

/// The resident elements of a box of a structure all of whose elements are resident; `values` are those of the box, in
/// row-major order.
template <class S>
ResidentOf<S> all_of(typename S::Address origin, typename S::Address size, std::vector<typename S::Element> values) {
    using A = typename S::Address;
    ResidentOf<S> found;
    found.values = std::move(values);
    found.addresses.reserve(found.values.size());
    const Extent extent = extent_of(size);
    for (std::size_t i = 0; i < found.values.size(); ++i) {
        A address = origin;
        std::size_t rest = i;
        if constexpr (Axes<A>::count == 1) address += static_cast<std::uint32_t>(rest);
        else
            for (unsigned axis = 0; axis < Axes<A>::count; rest /= extent[axis++])
                address[axis] += static_cast<std::uint32_t>(rest % extent[axis]);
        found.addresses.push_back(address);
    }
    return found;
}

}  // namespace detail

}  // namespace glift
