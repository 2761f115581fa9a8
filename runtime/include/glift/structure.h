// What generated structures and views share: ranges of elements. Structures also share access to single elements, and
// to boxes of elements that are moved between host and device.
#pragma once

#include <glift/draw_iteration.h>
#include <glift/iteration.h>
#include <glift/mapped_blocks.h>
#include <glift/range.h>
#include <glift/resident.h>
#include <glift/shared.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace glift {

namespace detail {

/// Structures whose elements lie in a buffer by affine maps, which gliftc has proved to lead nowhere beyond it
/// (has_rows of compiler/emit/cpp/translators.h): `place(a)` is the index of element a there, `row_memory()` the
/// buffer.
template <class S>
concept HasRows = requires(const S& s, typename S::Address a) {
    { s.place(a) } -> std::same_as<std::uint64_t>;
    { s.row_memory() } -> std::same_as<const Memory&>;
};

inline constexpr std::size_t most_rows = 1 << 16, most_regions = 1024;

/// The box as copy regions from row-major host bytes; adjacent rows are merged. Nullopt where the elements of a row are
/// not contiguous in the buffer, or where there are more than most_rows rows or most_regions regions: a kernel moves
/// such boxes.
template <class S> std::optional<std::vector<CopyRegion>> rows_of(const S& structure, typename S::Address origin,
                                                                  typename S::Address size) {
    using Address = typename S::Address;
    constexpr unsigned axes = Axes<Address>::count;
    constexpr std::uint64_t bytes = sizeof(typename S::Element);
    const Extent n = extent_of(size), first = extent_of(origin, 0);
    const auto place = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t w) {
        if constexpr (axes == 1) return structure.place(first[0] + x);
        else {
            Address address = origin;
            const std::uint32_t steps[] = {x, y, z, w};
            for (unsigned i = 0; i < axes; ++i) address[i] += steps[i];
            return structure.place(address);
        }
    };
    if (std::uint64_t{n[1]} * n[2] * n[3] > most_rows) return std::nullopt;
    if (n[0] > 1 && place(1, 0, 0, 0) != place(0, 0, 0, 0) + 1) return std::nullopt;
    std::vector<CopyRegion> regions;
    std::uint64_t at = 0;
    for (std::uint32_t w = 0; w < n[3]; ++w) {
        for (std::uint32_t z = 0; z < n[2]; ++z) {
            for (std::uint32_t y = 0; y < n[1]; ++y, at += n[0] * bytes) {
                const std::uint64_t to = place(0, y, z, w) * bytes;
                if (!regions.empty() && regions.back().to + regions.back().bytes == to)
                    regions.back().bytes += n[0] * bytes;
                else regions.push_back({at, to, n[0] * bytes});
                if (regions.size() > most_regions) return std::nullopt;
            }
        }
    }
    return regions;
}

/// Checks a structure passed in as a member of another one. Throws wrong_argument if it is empty, or if `alike` is
/// false: `alike` says whether it was made with the values that the declaration gives that member (structures that it
/// was made with are not compared).
template <class S> S&& part(S&& made, bool alike, const char* name) {
    if constexpr (requires { made.device(); }) (void)made.device();
    if (!alike) throw_other_part(name);
    return std::move(made);
}

}  // namespace detail

/// A list of types: those of a constructor's arguments (Arguments of generated classes).
template <class... T> struct Types {};

/// The bytes of a buffer with this many elements, a multiple of 4. The buffer has room for at least one element, so
/// that an empty structure has a memory too.
template <class T> constexpr std::uint64_t buffer_bytes(std::uint64_t count) {
    return saturated_sum(saturated_product(std::max<std::uint64_t>(1, count), sizeof(T)), 3) / 4 * 4;
}

/// The extent of an image, at least one texel along each axis.
template <class A> constexpr std::array<std::uint32_t, 3> image_extent(const A& extent) {
    const Extent e = detail::extent_of(extent);
    return {std::max(e[0], 1u), std::max(e[1], 1u), std::max(e[2], 1u)};
}

/// The extent of a cube's faces. An element address has the face as its third component, which is left out here.
template <class A> constexpr std::array<std::uint32_t, 3> cube_extent(const A& extent) {
    const auto e = image_extent(extent);
    return {e[0], e[1], 1};
}

/// The base of a generated view `Self`: its elements are computed where they are read.
template <class Self, class A, class T> class View {
public:
    using Address = A;
    using Element = T;

    Range<Self> range(A origin, A size) const {
        const Self& self = static_cast<const Self&>(*this);
        const detail::Box box{Self::type_name, detail::Axes<A>::count, detail::extent_of(origin, 0),
                              detail::extent_of(size), detail::extent_of(self.domain())};
        if (!box.is_inside()) detail::throw_outside(Self::type_name, "range", box);
        return Range<Self>(self, origin, size);
    }
    /// The first elements along each axis, as many as a value on the device says.
    Range<Self> first(DeviceScalar<A> count) const {
        return Range<Self>(static_cast<const Self&>(*this)).first(std::move(count));
    }
};

/// The base of a generated structure `Self` with virtual addresses of type A and elements of type T. Copies of a
/// structure share its memory. Values of a box are in row-major order, x running fastest. Within a body of
/// Device::record `write`, `copy_from` and `fill` (a member of `Self`) are recorded, and `read`, `read_resident` and
/// `map` throw, since they wait.
///
/// A generated structure itself has these members:
/// - domain(): the extent of the virtual domain;
/// - same_state(other): whether constructor values and the state of the parts are equal, so that kernels may use the
///   sizes of one for both;
/// - fill(value[, range]): gives every element, or those of a box, the same value;
/// - copy_out, copy_in: copy elements to a linear buffer, the first axis fastest, and back;
/// - place(address): the index of an element in row_memory(), where that is an affine function of the address;
/// - describe(see): calls see.value, see.memory, see.member or see.given for each part (glift/inspect.h);
/// - visit_state(visit): hands over, by reference, all that the structure consists of: visit.argument, visit.host,
///   visit.buffer, visit.image, visit.member, visit.base (a member that is the structure's memory), visit.given. Meant
///   for glift/files.h, as are Arguments, the types of the constructor's arguments, and state_key: equal for structures
///   whose states mean the same, whatever their elements and the layout of these.
template <class Self, class A, class T> class Structure {
public:
    using Address = A;
    using Element = T;

    const Device& device() const { return device_of("device"); }
    explicit operator bool() const { return bool(device_); }

    Range<Self> range(A origin, A size) const {
        check("range", origin, size);
        return Range<Self>(self(), origin, size);
    }

    /// Writes a box of elements from the host; the values are copied before the call returns. Throws wrong_argument
    /// where the box lies outside the domain, or where there is not one value per element.
    void write(A origin, A size, std::span<const T> values) {
        check("write", origin, size);
        if (values.size() != count(size))
            detail::throw_count(Self::type_name, values.size(), detail::extent_of(size), detail::Axes<A>::count);
        each_part(origin, size,
                  [&](A first, A extent, std::size_t at) { put(first, extent, values.subspan(at, count(extent))); });
    }
    void write(std::span<const T> values) { write({}, self().domain(), values); }

    /// Reads a box of elements to the host. Waits for all commands before it in the stream, not for later ones. Throws
    /// wrong_argument where the box lies outside the domain, out_of_memory where the host has no memory for the values.
    std::vector<T> read(A origin, A size) const {
        check("read", origin, size);
        std::vector<T> values;
        detail::make_values(
            Self::type_name, detail::Axes<A>::count, detail::extent_of(size), sizeof(T),
            {&values, [](void* list, std::size_t n) { static_cast<std::vector<T>*>(list)->resize(n); }});
        each_part(origin, size, [&](A first, A extent, std::size_t at) {
            const std::size_t bytes = count(extent) * sizeof(T);
            const Download download = fetch(first, extent, bytes);
            std::memcpy(values.data() + at, download.get().data(), bytes);
        });
        return values;
    }
    std::vector<T> read() const { return read({}, self().domain()); }

    /// The resident elements of a box (those that `find` of the language finds), with their addresses, as a Resident.
    /// Where the structure has blocks only these are looked at, else all addresses of the box: too_large is then thrown
    /// for more than 2^36, but not for structures without a `list` (HasList), which are read. Waits as `read` does.
    auto read_resident(A origin, A size) const {
        check("read_resident", origin, size);
        const Commands commands = not_recording("read_resident");
        if constexpr (detail::HasList<Self>) return detail::resident(Range<Self>(self(), origin, size), commands);
        else return detail::all_of<Self>(origin, size, read(origin, size));
    }
    auto read_resident() const { return read_resident({}, self().domain()); }

    /// One element, left on the device. Of structures that have rows (HasRows) this is a reference, whose value is read
    /// when it is used; of others a copy.
    DeviceScalar<T> element_in_place(const Commands& commands, A address) const {
        if constexpr (detail::HasRows<Self>) {
            check("element", address, A(1));
            return {self().row_memory(), self().place(address) * sizeof(T)};
        } else {
            return element(commands, address);
        }
    }
    /// A copy of one element, on the device.
    DeviceScalar<T> element(const Commands& commands, A address) const {
        check("element", address, A(1));
        const Memory box = commands.allocate(box_description(sizeof(T)));
        self().copy_out(commands, Range<Self>(self(), address, A(1)), box);
        return {box, 0};
    }
    /// The first elements along each axis, as many as a value on the device says.
    Range<Self> first(DeviceScalar<A> count) const { return Range<Self>(self()).first(std::move(count)); }

    /// Copies a range of another structure, with elements and addresses of the same types, to the box at `to_origin`.
    /// The two structures may be laid out differently.
    template <class Other> void copy_from(const Range<Other>& from, A to_origin = {}) {
        static_assert(std::is_same_v<typename Other::Element, T>);
        static_assert(std::is_same_v<typename Other::Address, A>);
        const A size = from.size();
        check("copy_from", to_origin, size);
        const Commands commands(device());
        each_part({}, size, [&](A first, A extent, std::size_t) {
            const Memory box = commands.allocate(box_description(count(extent) * sizeof(T)));
            const Range<Other> part = extent == size ? from : from.range(first, extent);
            part->copy_out(commands, part, box);
            self().copy_in(commands, Range<Self>(self(), to_origin + first, extent, part.device_counts()), box);
        });
    }

    /// Copies a whole structure.
    template <class Other>
    requires requires(const Other& whole) { whole.domain(); }
    void copy_from(const Other& from, A to_origin = {}) { copy_from(Range<Other>(from), to_origin); }

    /// A box on the host, which is written back: a Mapped, a copy, for which the call waits as `read` does; or, of
    /// structures with blocks, a MappedBlocks, whose parts are read where they are accessed. Throws as `read` does.
    auto map(A origin, A size) {
        check("map", origin, size);
        not_recording("map");
        if constexpr (detail::HasBlocks<Self>) return MappedBlocks<Self>(self(), origin, size);
        else return Mapped<Self>(self(), origin, size);
    }
    auto map() { return map({}, self().domain()); }

protected:
    Structure() = default;
    explicit Structure(const Device& device) : device_(device) {}

private:
    Self& self() { return static_cast<Self&>(*this); }
    const Self& self() const { return static_cast<const Self&>(*this); }
    static std::size_t count(const A& size) {
        return static_cast<std::size_t>(detail::volume_of(detail::extent_of(size)));
    }

    /// Calls f(origin, size, number of elements before the part) for each part of a box. Boxes are moved in parts of
    /// about 1 GiB at most, so that staging memory stays bounded. The box is split along the last axis that is longer
    /// than one and, where that is not enough, along the axes before it, too.
    template <class F> static void each_part(A origin, A size, F f, std::size_t before = 0) {
        constexpr std::uint64_t most = (std::uint64_t{1} << 30) / sizeof(T) + 1;
        const std::uint64_t elements = detail::volume_of(detail::extent_of(size));
        if (elements == 0) return;
        if (elements <= most) return f(origin, size, before);
        unsigned axis = detail::Axes<A>::count - 1;
        const Extent extent = detail::extent_of(size);
        while (axis > 0 && extent[axis] == 1) --axis;
        const std::uint64_t row = elements / extent[axis];
        const auto step = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(most / row, 1, extent[axis]));
        for (std::uint64_t at = 0; at < extent[axis]; at += step) {
            const auto length = static_cast<std::uint32_t>(std::min<std::uint64_t>(step, extent[axis] - at));
            A first = origin, part = size;
            if constexpr (detail::Axes<A>::count == 1) {
                first += static_cast<std::uint32_t>(at);
                part = length;
            } else {
                first[axis] += static_cast<std::uint32_t>(at);
                part[axis] = length;
            }
            each_part(first, part, f, before + at * row);
        }
    }

    void put(A origin, A size, std::span<const T> values) {
        const Commands commands(device());
        if constexpr (detail::HasRows<Self>) {
            if (const auto rows = detail::rows_of(self(), origin, size))
                return commands.upload(self().row_memory(), *rows, std::as_bytes(values));
        }
        const Memory box = commands.allocate(box_description(values.size_bytes()));
        commands.upload(box, 0, std::as_bytes(values));
        self().copy_in(commands, Range<Self>(self(), origin, size), box);
    }

    Download fetch(A origin, A size, std::size_t bytes) const {
        const Commands commands = not_recording("read");
        if constexpr (detail::HasRows<Self>) {
            if (auto rows = detail::rows_of(self(), origin, size)) {
                for (CopyRegion& row : *rows) std::swap(row.from, row.to);
                return commands.download(self().row_memory(), *rows, bytes);
            }
        }
        const Memory box = commands.allocate(box_description(bytes));
        self().copy_out(commands, Range<Self>(self(), origin, size), box);
        return commands.download(box, 0, bytes);
    }

    static MemoryDescription box_description(std::size_t bytes) {
        return {.name = "box", .bytes = (bytes + 3) / 4 * 4, .zeroed = false};
    }
    /// Commands that run at once. Throws where they would be recorded, since the operation waits.
    Commands not_recording(const char* operation) const {
        Commands commands(device());
        if (commands.is_recording())
            detail::throw_not_in_recording((std::string(Self::type_name) + "::" + operation).c_str());
        return commands;
    }
    const Device& device_of(const char* operation) const {
        if (!device_) detail::throw_empty_structure(Self::type_name, operation);
        return device_;
    }
    void check(const char* operation, A origin, A size) const {
        device_of(operation);
        const detail::Box box{Self::type_name, detail::Axes<A>::count, detail::extent_of(origin, 0),
                              detail::extent_of(size), detail::extent_of(self().domain())};
        if (!box.is_inside()) detail::throw_outside(Self::type_name, operation, box);
    }
    Device device_;
};

}  // namespace glift
