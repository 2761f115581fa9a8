// A structure's parts and its resident elements (resident.h), as a file from which `tools/inspect` draws pictures. No
// container is known by name: the parts are those that generated classes list themselves (`describe`).
//
//     glift::inspect(grid, "grid").save("grid.inspection");
//
// This header is not part of <glift/glift.h>. Structures may have any size. inspect() waits for the device. It reads
// the elements in some planes; of structures with a `list` (HasList of resident.h) it also reads all resident elements,
// unless they are more than InspectionOptions::most_elements. It reads none where all addresses of a domain would have
// to be looked at, and they are more than most_searched (resident.h).
#pragma once

#include <glift/inspected_values.h>
#include <glift/structure.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace glift {

struct InspectionOptions {
    /// The most pixels along each axis of a picture of a plane. The picture of a structure of one axis has up to the
    /// square of this number.
    std::uint32_t most_pixels = 512;
    std::uint64_t most_elements = std::uint64_t{1} << 25;  ///< where more are resident, only planes are read
};

/// A structure as text in the format that docs/how-to/inspect.md describes.
class Inspection {
public:
    explicit Inspection(std::string text) : text_(std::move(text)) {}
    const std::string& text() const { return text_; }

    /// Replaces the file at once, so that `tools/inspect --follow` may read it at any time. Throws wrong_argument.
    GLIFT_API void save(const std::string& path) const;

private:
    std::string text_;
};

namespace detail {

// ---------------------------------------------------------------------------------------------------------- pictures

/// A box of addresses, divided along each axis into `count` cells of `cell` addresses each (the last one may have
/// fewer). The constructor's `most` bounds `count`.
struct Cells {
    Extent first{}, size{1, 1, 1, 1}, cell{1, 1, 1, 1}, count{1, 1, 1, 1};

    Cells(const Extent& begin, const Extent& extent, const Extent& most) : first(begin), size(extent) {
        for (unsigned i = 0; i < 4; ++i) {
            cell[i] = std::max(1u, static_cast<std::uint32_t>((std::uint64_t{size[i]} + most[i] - 1) / most[i]));
            count[i] = static_cast<std::uint32_t>((std::uint64_t{size[i]} + cell[i] - 1) / cell[i]);
        }
    }
    std::size_t number() const { return std::size_t{count[0]} * count[1] * count[2] * count[3]; }
    std::size_t index_of(const Extent& address) const {
        std::size_t index = 0;
        for (unsigned i = 4; i-- > 0;) index = index * count[i] + (address[i] - first[i]) / cell[i];
        return index;
    }
    bool has(const Extent& address) const {
        for (unsigned i = 0; i < 4; ++i)
            if (address[i] < first[i] || address[i] - first[i] >= size[i]) return false;
        return true;
    }
    void put(JsonObject& to, unsigned rank) const {
        to.put("first", json_extent(first, rank));
        to.put("size", json_extent(size, rank));
        to.put("cell", json_extent(cell, rank));
        to.put("count", json_extent(count, rank));
    }
};

/// How many of these addresses lie in each cell of the domain. Also called for physical addresses (Resident::places):
/// `domain` is then the extent of the memory.
template <class A> std::string json_counts(const std::vector<A>& addresses, const Extent& domain, std::uint32_t most) {
    constexpr unsigned rank = Axes<A>::count;
    const Cells cells({}, domain,
                      rank > 2 ? Extent{std::max(most / 4, 1u), std::max(most / 4, 1u), 64, 8}
                               : Extent{std::max(most, 1u), std::max(most, 1u), 1, 1});
    std::vector<std::uint32_t> counts(cells.number());
    for (const A& address : addresses)
        if (const Extent at = extent_of(address, 0); cells.has(at)) ++counts[cells.index_of(at)];
    JsonObject object;
    cells.put(object, rank);
    object.put("counts", json_numbers(counts));
    return object.text();
}

/// The largest result of number_in: stands for all numbers that are not smaller. Also for an element that is not
/// resident.
inline constexpr std::uint32_t no_place = UINT32_MAX;
/// The physical address of an element (Resident::places) as one number, counted in row-major order in a memory of this
/// extent; `no_place` at most.
inline std::uint32_t number_in(const Extent& place, const Extent& extent) {
    std::uint64_t number = 0;
    for (unsigned i = 4; i-- > 0;) number = saturated_sum(saturated_product(number, extent[i]), place[i]);
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(number, no_place));
}

/// A box of addresses, both ends included, and the address that planes go through.
struct Bounds {
    Extent low{}, high{}, middle{};

    explicit Bounds(const Extent& domain) {
        for (unsigned i = 0; i < 4; ++i) {
            high[i] = std::max(domain[i], 1u) - 1;
            middle[i] = high[i] / 2;
        }
    }
    /// Along the axes on which the domain is longer than a picture, narrows the box to the span of these addresses.
    /// `middle` becomes the address in the middle of the list.
    template <class A> void narrow(const std::vector<A>& addresses, const Extent& domain, std::uint32_t most) {
        for (unsigned i = 0; i < 4; ++i) {
            if (domain[i] <= most) continue;
            low[i] = high[i], high[i] = 0;
            for (const A& address : addresses) {
                low[i] = std::min(low[i], extent_of(address, 0)[i]);
                high[i] = std::max(high[i], extent_of(address, 0)[i]);
            }
        }
        middle = extent_of(addresses[addresses.size() / 2], 0);
    }
};

/// Pictures of a structure along planes of its domain.
template <class S> class Planes {
public:
    using Address = typename S::Address;
    static constexpr unsigned rank = Axes<Address>::count;

    Planes(const S& structure, const Bounds& bounds, const Extent& places, std::uint32_t most)
        : structure_(structure), bounds_(bounds), places_(places), most_(most) {}

    /// The planes through the middle along each pair of the first three axes; for a structure of one axis, a line.
    /// Where the addresses along the last of three or four axes end below 16, as along an axis of levels, there is
    /// instead one plane along the first two axes for each address along the last one.
    std::string json() {
        constexpr unsigned last = rank - 1;
        if (rank >= 3 && bounds_.high[last] < 16) {
            Extent through = bounds_.middle;
            for (through[last] = bounds_.low[last]; through[last] <= bounds_.high[last]; ++through[last])
                add(through, 0, 1);
            return json_list(planes_);
        }
        add(bounds_.middle, 0, 1);
        if (rank >= 3) add(bounds_.middle, 0, 2), add(bounds_.middle, 1, 2);
        return json_list(planes_);
    }

private:
    /// The most addresses that are read along an axis of a plane; along a line the square of this.
    static constexpr std::uint32_t most_read = 4096;

    /// Adds the plane along axes x and y, with the value and the physical address (number_in) of one resident element
    /// of each cell; NaN and no_place where none is resident.
    void add(const Extent& through, unsigned x, unsigned y) {
        Extent first = through, size{1, 1, 1, 1}, cells_along{1, 1, 1, 1};
        for (unsigned axis : {x, y}) {
            const std::uint32_t longest = rank == 1 ? most_read * most_read : most_read;
            const std::uint32_t length = bounds_.high[axis] - bounds_.low[axis] + 1;
            size[axis] = std::min(length, longest);
            first[axis] = bounds_.low[axis] + (length - size[axis]) / 2;
            cells_along[axis] = static_cast<std::uint32_t>(
                std::clamp<std::uint64_t>(rank == 1 ? std::uint64_t{most_} * most_ : most_, 1, UINT32_MAX));
        }
        if constexpr (rank == 1) size[1] = 1, first[1] = 0;
        const auto found = structure_.read_resident(address_of(first), address_of(size));
        const Cells cells(first, size, cells_along);
        std::vector<float> values(cells.number(), NAN);
        std::vector<std::uint32_t> where(found.places.empty() ? 0 : cells.number(), no_place);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const std::size_t cell = cells.index_of(extent_of(found.addresses[i], 0));
            values[cell] = static_cast<float>(number_of(found.values[i]));
            if (!where.empty()) where[cell] = number_in(extent_of(found.places[i], 0), places_);
        }
        JsonObject object;
        object.put("axes", "[" + std::to_string(x) + ", " + std::to_string(y) + "]");
        object.put("through", json_extent(through, rank));
        cells.put(object, rank);
        object.put("values", json_numbers(values));
        if (!where.empty()) object.put("places", json_numbers(where));
        planes_.push_back(object.text());
    }

    static Address address_of(const Extent& extent) {
        Address address{};
        if constexpr (rank == 1) address = extent[0];
        else
            for (unsigned i = 0; i < rank; ++i) address[i] = extent[i];
        return address;
    }

    const S& structure_;
    const Bounds& bounds_;
    const Extent& places_;
    std::uint32_t most_;
    std::vector<std::string> planes_;
};

// ------------------------------------------------------------------------------------------------------------- parts

/// The memories of a structure and of what it is made of, each once, with their bytes: in `elements` those that hold
/// its elements, in `tables` those of its members and of structures given to it.
struct Memories : SeesNothing {
    std::map<const void*, std::uint64_t> elements, tables;
    bool is_table = false;

    void memory(const char*, const Memory& memory) {
        if (memory) (is_table ? tables : elements)[memory.object()] = memory.description().bytes;
    }
    template <class S> void memory(const char*, const S& structure) { structure.describe(*this); }
    template <class S> void member(const char*, const S& structure) {
        const bool before = std::exchange(is_table, true);
        structure.describe(*this);
        is_table = before;
    }
    template <class S> void given(const char* name, const S& structure) { member(name, structure); }

    /// Of all; a memory of a given structure that holds the elements (`memory frames = pool.frames`) is in both maps.
    std::uint64_t bytes() const {
        std::map<const void*, std::uint64_t> all = elements;
        all.insert(tables.begin(), tables.end());
        return sum(all);
    }
    static std::uint64_t sum(const std::map<const void*, std::uint64_t>& all) {
        std::uint64_t bytes = 0;
        for (const auto& [memory, size] : all) bytes += size;
        return bytes;
    }
};

/// The extent of the memory that the elements' physical addresses (Resident::places) refer to.
template <class S> struct PlaceExtent : SeesNothing {
    Extent extent{1, 1, 1, 1};
    bool is_known = false;

    void memory(const char*, const Memory& memory) {
        if (!memory || is_known) return;
        const MemoryDescription& made = memory.description();
        if (made.kind == MemoryKind::buffer)
            extent = {fitted(std::min<std::uint64_t>(made.bytes / sizeof(typename S::Element), UINT32_MAX)), 1, 1, 1};
        else extent = {made.extent[0], made.extent[1], made.extent[2], 1};
        is_known = true;
    }
    template <class B>
    requires requires(const B& base) { base.domain(); }
    void memory(const char*, const B& base) {
        if constexpr (HasList<S>) {
            if (!S::translates) {
                PlaceExtent<B> of_base;
                base.describe(of_base);
                extent = of_base.extent;
                is_known = true;
                return;
            }
        }
        extent = extent_of(base.domain());
        is_known = true;
    }
};

/// Writes a structure and its parts.
class Inspector {
public:
    explicit Inspector(const InspectionOptions& options) : options_(options) {}

    template <class S> std::string object(const S& structure, const std::string& name, const char* role) {
        JsonObject json;
        json.put("name", quoted(name));
        json.put("role", quoted(role));
        json.put("type", quoted(S::type_name));
        Memories memories;
        structure.describe(memories);
        // A container has no elements: all that it has is parts.
        constexpr bool has_elements = requires { structure.domain(); };
        json.put("bytes", memories.bytes());
        if (has_elements) json.put("bytes_of_elements", Memories::sum(memories.elements));
        if constexpr (has_elements) {
            constexpr unsigned rank = Axes<typename S::Address>::count;
            json.put("domain", json_extent(extent_of(structure.domain()), rank));
        }
        const bool is_shown = !shown_.insert(identity(structure, memories)).second;
        if (is_shown) json.put("shown", "true");
        else if constexpr (requires { structure.read_resident(); }) elements(json, structure);
        if (!is_shown) parts(json, structure);
        return json.text();
    }

private:
    struct Parts : SeesNothing {
        Parts(Inspector& owner) : inspector(owner) {}
        template <class T> void value(const char* name, const T& value) {
            JsonObject json;
            json.put("name", quoted(name));
            json.put("text", quoted(text_of_value(value)));
            values.push_back(json.text());
        }
        void memory(const char* name, const Memory& memory) {
            if (!memory) return;
            const MemoryDescription& made = memory.description();
            JsonObject json;
            json.put("name", quoted(name));
            json.put("kind", quoted(made.kind == MemoryKind::buffer ? "buffer" : "image"));
            json.put("bytes", made.bytes);
            json.put("extent", json_extent({made.extent[0], made.extent[1], made.extent[2], 1}, 3));
            json.put("mips", made.mips);
            memories.push_back(json.text());
        }
        template <class S> void memory(const char* name, const S& part) { add(name, part, "memory"); }
        template <class S> void member(const char* name, const S& part) { add(name, part, "member"); }
        template <class S> void given(const char* name, const S& part) { add(name, part, "given"); }
        template <class S> void add(const char* name, const S& part, const char* role) {
            parts.push_back(inspector.object(part, name, role));
        }
        Inspector& inspector;
        std::vector<std::string> values, memories, parts;
    };

    template <class S> void parts(JsonObject& json, const S& structure) {
        Parts found(*this);
        structure.describe(found);
        json.put("values", json_list(found.values));
        json.put("memories", json_list(found.memories));
        json.put("parts", json_list(found.parts));
    }

    template <class S> static std::string identity(const S&, const Memories& memories) {
        std::string text = S::type_name;
        for (const auto* all : {&memories.elements, &memories.tables})
            for (const auto& [memory, bytes] : *all)
                text += " " + std::to_string(reinterpret_cast<std::uintptr_t>(memory));
        return text;
    }

    /// The number of resident elements; nullopt where the structure has no blocks and its domain has more than
    /// most_searched addresses, each of which would have to be looked at.
    template <class S> static std::optional<std::uint64_t> count_of(const S& structure) {
        const std::uint64_t all = volume_of(extent_of(structure.domain()));
        if constexpr (HasList<S>) {
            if (!S::has_blocks && all > most_searched) return std::nullopt;
            if (all == 0) return all;
            ResidentOf<S> none;
            return list(Range<S>(structure), Commands(structure.device()), 0, none);
        } else {
            return all;
        }
    }

    template <class S> void elements(JsonObject& json, const S& structure) {
        const std::optional<std::uint64_t> count = count_of(structure);
        if (!count) {
            json.put("not_read", quoted("a domain in which every address would have to be looked at: inspect what has "
                                        "blocks over it, such as std.paged.ListedPages"));
            return;
        }
        json.put("elements", *count);
        if (*count == 0) return;
        const Extent domain = extent_of(structure.domain());
        Bounds bounds(domain);
        PlaceExtent<S> places;
        structure.describe(places);
        if constexpr (HasList<S>) {
            if (*count <= options_.most_elements) {
                const auto found = structure.read_resident();
                json.put("resident", json_counts(found.addresses, domain, options_.most_pixels));
                json.put("use", json_counts(found.places, places.extent, 128));
                bounds.narrow(found.addresses, domain, options_.most_pixels);
            } else {
                json.put("not_read",
                         quoted("more elements than InspectionOptions::most_elements: only planes of them"));
            }
        }
        json.put("planes", Planes<S>(structure, bounds, places.extent, options_.most_pixels).json());
    }

    InspectionOptions options_;
    std::set<std::string> shown_;
};

}  // namespace detail

/// Inspects a structure that gliftc generated, and each of its parts: sizes, the results of its
/// functions without arguments, and the resident elements. Errors are those of `read_resident` and of these functions.
template <class S>
Inspection inspect(const S& structure, const std::string& name = "structure", const InspectionOptions& options = {}) {
    detail::JsonObject json;
    json.put("glift_inspection", std::uint64_t{1});
    if constexpr (requires { structure.device(); })
        json.put("device", detail::quoted(structure.device().properties().name));
    json.put("root", detail::Inspector(options).object(structure, name, "root"));
    return Inspection(json.text() + "\n");
}

}  // namespace glift
