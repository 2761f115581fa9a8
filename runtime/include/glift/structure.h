// What all generated structures share: boxes of them as values, and moving boxes of elements between host and device.
#pragma once

#include <glift/commands.h>
#include <glift/error.h>
#include <glift/vector.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace glift {

using Extent = std::array<std::uint32_t, 4>;

namespace detail {

template <class A> struct Axes {
    static constexpr unsigned count = 1;
    static constexpr std::uint32_t at(A a, unsigned) { return a; }
};
template <unsigned N> struct Axes<vec<uint, N>> {
    static constexpr unsigned count = N;
    static constexpr std::uint32_t at(const vec<uint, N>& a, unsigned i) { return a[i]; }
};

/// A virtual address or size as four numbers; axes that it does not have are `rest`.
template <class A> constexpr Extent extent_of(const A& a, std::uint32_t rest = 1) {
    Extent extent;
    for (unsigned i = 0; i < 4; ++i) extent[i] = i < Axes<A>::count ? Axes<A>::at(a, i) : rest;
    return extent;
}

constexpr std::uint64_t volume_of(const Extent& extent) {
    return std::uint64_t{extent[0]} * extent[1] * extent[2] * extent[3];
}

inline std::string text_of(const Extent& extent, unsigned rank) {
    std::string text = "{";
    for (unsigned i = 0; i < rank; ++i) text += (i ? ", " : "") + std::to_string(extent[i]);
    return text + "}";
}

/// A box as the checks see it.
struct Box {
    const char* name;
    unsigned rank;
    Extent origin, size, domain;

    bool is_inside() const {
        for (unsigned i = 0; i < rank; ++i) {
            if (size[i] > domain[i] || origin[i] > domain[i] - size[i]) return false;
        }
        return true;
    }
};

[[noreturn]] inline void throw_outside(const std::string& where, const Box& box) {
    throw Error(ErrorCode::wrong_argument, std::string("a box of ") + box.name + " lies outside its domain", where,
                box.name + (" starts at " + text_of(box.origin, box.rank)) + " and is " + text_of(box.size, box.rank) +
                    " large, the domain is " + text_of(box.domain, box.rank),
                "pass a box inside the domain");
}

}  // namespace detail

/// A value that lives on the device.
template <class T> struct DeviceScalar {
    Memory memory;
    std::uint64_t offset = 0;

    /// Waits for what the value depends on.
    T await(const Commands& commands) const {
        const Download download = commands.download(memory, offset, sizeof(T));
        T value;
        std::memcpy(&value, download.get().data(), sizeof(T));
        return value;
    }
    operator DeviceValue() const { return {memory, offset}; }
};

namespace detail {

/// A size that lives on the device, of a box that begins `before` elements after what it is the size of.
struct DeviceCount {
    DeviceValue value;
    Extent before{};

    bool operator==(const DeviceCount& other) const {
        return value.memory.object() == other.value.memory.object() && value.offset == other.value.offset &&
               before == other.before;
    }
};

}  // namespace detail

/// A box of a structure of type S, or all of it. Holds on to the structure by address.
template <class S> class Range {
public:
    using Address = typename S::Address;

    Range(const S& structure) : structure_(&structure), size_(structure.domain()), whole_(true) {}
    Range(const S& structure, Address origin, Address size) : structure_(&structure), origin_(origin), size_(size) {}
    /// As many elements along each axis as a value on the device says, `size` at most.
    Range(const S& structure, Address origin, Address size, DeviceScalar<Address> count)
        : structure_(&structure), origin_(origin), size_(size), counts_{{std::move(count), {}}} {}

    const S& structure() const { return *structure_; }
    const S* operator->() const { return structure_; }
    Address origin() const { return origin_; }
    Address size() const { return size_; }
    bool is_whole() const { return whole_; }
    /// Where the number of elements along each axis comes from, the least of these; none where the host knows it.
    const std::vector<detail::DeviceCount>& device_counts() const { return counts_; }

    /// A box of this box.
    Range range(Address origin, Address size) const {
        Range part(*structure_, origin_ + origin, size);
        part.counts_ = counts_;
        const Extent first = detail::extent_of(origin, 0);
        for (detail::DeviceCount& count : part.counts_)
            for (unsigned i = 0; i < 4; ++i) count.before[i] += first[i];
        return part;
    }
    /// As many elements from the first on, along each axis, as a value on the device says, all at most.
    Range first(DeviceScalar<Address> count) const {
        Range part(*structure_, origin_, size_);
        part.counts_ = counts_;
        part.counts_.push_back({std::move(count), {}});
        return part;
    }
    /// An element of the box, left on the device.
    auto element_in_place(const Commands& commands, Address address) const {
        return structure_->element_in_place(commands, origin_ + address);
    }
    auto element(const Commands& commands, Address address) const {
        return structure_->element(commands, origin_ + address);
    }
    std::vector<typename S::Element> read() const { return structure_->read(origin_, size_); }

private:
    const S* structure_;
    Address origin_{};
    Address size_;
    std::vector<detail::DeviceCount> counts_;
    bool whole_ = false;
};

/// How many elements a structure or a box has.
template <class S> uint element_count(const S& structure) {
    if constexpr (requires { structure.size(); })
        return static_cast<uint>(detail::volume_of(detail::extent_of(structure.size())));
    else return static_cast<uint>(detail::volume_of(detail::extent_of(structure.domain())));
}

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
    std::vector<detail::DeviceCount> counts_;  ///< of what is visited
    std::array<Patch, 24> patches_{};
    std::size_t patch_count_ = 0;
};

/// A parameter block as bytes. There are two types of blocks a kernel: std::as_bytes would take longer to compile for
/// them than all else of the call.
template <class T> std::span<const std::byte> bytes_of(const T& value) {
    return {reinterpret_cast<const std::byte*>(&value), sizeof value};
}

/// A box of elements on the host, written back to the structure when it is unmapped or goes out of scope.
template <class S> class Mapped {
public:
    using Address = typename S::Address;
    using Element = typename S::Element;

    Mapped(S& structure, Address origin, Address size)
        : structure_(&structure), origin_(origin), size_(size), values_(structure.read(origin, size)) {}
    Mapped(Mapped&& other) noexcept
        : structure_(std::exchange(other.structure_, nullptr)), origin_(other.origin_), size_(other.size_),
          values_(std::move(other.values_)) {}
    Mapped& operator=(Mapped&&) = delete;
    ~Mapped() { unmap(); }

    /// By address in the box: the origin is zero.
    Element& operator[](Address address) {
        const Extent a = detail::extent_of(address, 0), n = detail::extent_of(size_);
        return values_[((std::size_t{a[3]} * n[2] + a[2]) * n[1] + a[1]) * n[0] + a[0]];
    }
    std::span<Element> values() { return values_; }
    Address size() const { return size_; }

    void unmap() {
        if (S* structure = std::exchange(structure_, nullptr)) structure->write(origin_, size_, values_);
    }

private:
    S* structure_;
    Address origin_, size_;
    std::vector<Element> values_;
};

namespace detail {

/// Structures whose translator is affine and leads into a buffer: they say where an element lies.
template <class S>
concept HasRows = requires(const S& s, typename S::Address a) {
    { s.place(a) } -> std::same_as<std::uint64_t>;
    { s.row_memory() } -> std::same_as<const Memory&>;
};

inline constexpr std::size_t most_rows = 1 << 16, most_regions = 1024;

/// The box as copies from host bytes, where elements stand in row-major order: each element once, rows that follow each
/// other as one. Nothing where rows are not contiguous or too many: such boxes go through a kernel.
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

}  // namespace detail

/// The bytes of a buffer with this many elements; never none, so that an empty structure has a memory too.
template <class T> constexpr std::uint64_t buffer_bytes(std::uint32_t count) {
    return (std::max<std::uint64_t>(1, std::uint64_t{count}) * sizeof(T) + 3) / 4 * 4;
}

/// The texels of an image; never none.
template <class A> constexpr std::array<std::uint32_t, 3> image_extent(const A& extent) {
    const Extent e = detail::extent_of(extent);
    return {std::max(e[0], 1u), std::max(e[1], 1u), std::max(e[2], 1u)};
}

/// The base of a generated view `Self`: its elements are computed.
template <class Self, class A, class T> class View {
public:
    using Address = A;
    using Element = T;

    Range<Self> range(A origin, A size) const {
        const Self& self = static_cast<const Self&>(*this);
        const detail::Box box{Self::type_name, detail::Axes<A>::count, detail::extent_of(origin, 0),
                              detail::extent_of(size), detail::extent_of(self.domain())};
        if (!box.is_inside()) detail::throw_outside(std::string(Self::type_name) + "::range", box);
        return Range<Self>(self, origin, size);
    }
    /// As many elements from the first on, along each axis, as a value on the device says.
    Range<Self> first(DeviceScalar<A> count) const {
        return Range<Self>(static_cast<const Self&>(*this)).first(std::move(count));
    }
};

/// The base of a generated structure `Self` with virtual addresses of type A and elements of type T. Copies of a
/// structure share its memory. Values of a box are in row-major order, x running fastest.
template <class Self, class A, class T> class Structure {
public:
    using Address = A;
    using Element = T;

    const Device& device() const { return *device_; }
    explicit operator bool() const { return device_.has_value(); }

    Range<Self> range(A origin, A size) const {
        const Range<Self> range(self(), origin, size);
        check("range", range);
        return range;
    }

    /// From the host to the device; the values are copied before the call returns.
    void write(A origin, A size, std::span<const T> values) {
        const Range<Self> range(self(), origin, size);
        check("write", range);
        if (values.size() != count(size)) throw_count(values.size(), size);
        if (values.empty()) return;
        const Commands commands(device());
        if constexpr (detail::HasRows<Self>) {
            if (const auto rows = detail::rows_of(self(), origin, size))
                return commands.upload(self().row_memory(), *rows, std::as_bytes(values));
        }
        const Memory box = new_box(values.size_bytes());
        commands.upload(box, 0, std::as_bytes(values));
        self().copy_in(commands, range, box);
    }
    void write(std::span<const T> values) { write({}, self().domain(), values); }

    /// Waits for what the box depends on, no more.
    std::vector<T> read(A origin, A size) const {
        const Range<Self> range(self(), origin, size);
        check("read", range);
        std::vector<T> values(count(size));
        if (values.empty()) return values;
        const Download download = fetch(range, values.size() * sizeof(T));
        std::memcpy(values.data(), download.get().data(), values.size() * sizeof(T));
        return values;
    }
    std::vector<T> read() const { return read({}, self().domain()); }

    /// One element where it lies, left on the device: what it is when it is used, which may be later.
    DeviceScalar<T> element_in_place(const Commands& commands, A address) const {
        if constexpr (detail::HasRows<Self>) {
            check("element", Range<Self>(self(), address, A(1)));
            return {self().row_memory(), self().place(address) * sizeof(T)};
        } else {
            return element(commands, address);
        }
    }
    /// One element as it is now, left on the device.
    DeviceScalar<T> element(const Commands& commands, A address) const {
        const Range<Self> range(self(), address, A(1));
        check("element", range);
        const Memory box = commands.allocate(box_description(sizeof(T)));
        self().copy_out(commands, range, box);
        return {box, 0};
    }
    /// As many elements from the first on, along each axis, as a value on the device says.
    Range<Self> first(DeviceScalar<A> count) const { return Range<Self>(self()).first(std::move(count)); }

    /// A box of another structure with the same elements; the two may be laid out differently.
    template <class Other> void copy_from(const Range<Other>& from, A to_origin = {}) {
        static_assert(std::is_same_v<typename Other::Element, T>);
        static_assert(std::is_same_v<typename Other::Address, A>);
        const A size = from.size();
        const Range<Self> to(self(), to_origin, size);
        check("copy_from", to);
        if (count(size) == 0) return;
        const Commands commands(device());
        const Memory box = new_box(count(size) * sizeof(T));
        from->copy_out(commands, from, box);
        self().copy_in(commands, to, box);
    }

    Mapped<Self> map(A origin, A size) { return {self(), origin, size}; }
    Mapped<Self> map() { return {self(), {}, self().domain()}; }

protected:
    Structure() = default;
    explicit Structure(const Device& device) : device_(device) {}

private:
    Self& self() { return static_cast<Self&>(*this); }
    const Self& self() const { return static_cast<const Self&>(*this); }
    static std::size_t count(const A& size) {
        return static_cast<std::size_t>(detail::volume_of(detail::extent_of(size)));
    }

    Download fetch(const Range<Self>& range, std::size_t bytes) const {
        const Commands commands(device());
        if constexpr (detail::HasRows<Self>) {
            if (auto rows = detail::rows_of(self(), range.origin(), range.size())) {
                for (CopyRegion& row : *rows) std::swap(row.from, row.to);
                return commands.download(self().row_memory(), *rows, bytes);
            }
        }
        const Memory box = new_box(bytes);
        self().copy_out(commands, range, box);
        return commands.download(box, 0, bytes);
    }

    static MemoryDescription box_description(std::size_t bytes) {
        return {.name = "box", .bytes = (bytes + 3) / 4 * 4, .zeroed = false};
    }
    Memory new_box(std::size_t bytes) const { return device().allocate(box_description(bytes)); }
    void check(const char* operation, const Range<Self>& range) const {
        const detail::Box box{Self::type_name, detail::Axes<A>::count, detail::extent_of(range.origin(), 0),
                              detail::extent_of(range.size()), detail::extent_of(self().domain())};
        if (!box.is_inside()) detail::throw_outside(std::string(Self::type_name) + "::" + operation, box);
    }
    [[noreturn]] void throw_count(std::size_t given, const A& size) const {
        throw Error(ErrorCode::wrong_argument, "the values do not fill the box",
                    std::string(Self::type_name) + "::write",
                    std::to_string(given) + " values for a box of " +
                        detail::text_of(detail::extent_of(size), detail::Axes<A>::count),
                    "pass one value an element");
    }

    std::optional<Device> device_;
};

}  // namespace glift
