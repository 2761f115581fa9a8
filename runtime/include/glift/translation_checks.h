// Checks of translators, which `gliftc test` runs for the structures in use; it names those that it cannot check.
#pragma once

#include <glift/testing.h>

#include <algorithm>
#include <utility>

namespace glift {

/// Addresses that a translator is tested with: all addresses of a small domain, else samples at a regular step. For a
/// translator after the first, they are the results of the translators before it.
template <class A> struct Tried {
    std::vector<A> addresses;
    std::string domain;    ///< of the structure, as text
    bool complete = true;  ///< the whole domain is tested, and the translators so far map it one-to-one
};

/// `residents`: addresses in blocks, which are tried, too, if not all addresses of the domain are.
template <class A> Tried<A> tried(const A& domain, const std::vector<A>& residents) {
    constexpr unsigned rank = detail::Axes<A>::count;
    const Extent extent = detail::extent_of(domain);
    const std::uint64_t volume = detail::volume_of(extent);
    const std::uint64_t step = volume <= 1u << 17 ? 1 : volume / 20000 | 1;
    Tried<A> result{{}, detail::text_of(extent, rank), step == 1};
    for (std::uint64_t i = 0; i < volume; i += step)
        result.addresses.push_back(detail::address_from<A>(detail::address_of(i, extent)));
    if (!result.complete) result.addresses.insert(result.addresses.end(), residents.begin(), residents.end());
    return result;
}

namespace detail {
/// Whether an address lies inside a memory of this extent.
GLIFT_API bool is_within(const Extent& limit, const Extent& address);
}  // namespace detail

/// Thrown where a translator reads a table out of bounds. Addresses for which `translate` does so are not checked;
/// where only `invert` does so, the address that it gives is not compared.
struct OutsideTable {};

/// A copy of a table's elements on the host, for translators that read the table. The elements of a view are computed
/// on the device and then copied.
template <class S> class Mirror {
public:
    using Address = typename S::Address;
    using Element = typename S::Element;

    Mirror(const S& table, const Commands& commands) : domain_(detail::extent_of(table.domain())) {
        if (detail::volume_of(domain_) > 1u << 22)
            throw Error(ErrorCode::too_large, std::string("a table too large to look through: ") + S::type_name);
        if constexpr (requires { table.read(); }) values_ = table.read();
        else values_ = computed(table, commands);
    }
    Element operator[](const Address& address) const {
        const Extent at = detail::extent_of(address, 0);
        std::size_t index = 0;
        for (unsigned axis = 4; axis-- > 0;) {
            if (at[axis] >= domain_[axis]) throw OutsideTable{};
            index = index * domain_[axis] + at[axis];
        }
        return values_[index];
    }

private:
    static std::vector<Element> computed(const S& view, const Commands& commands) {
        std::vector<Element> values(detail::volume_of(detail::extent_of(view.domain())));
        if (values.empty()) return values;
        const std::size_t bytes = values.size() * sizeof(Element);
        const Memory box = commands.allocate({.name = "box", .bytes = (bytes + 3) / 4 * 4, .zeroed = false});
        view.copy_out(commands, Range<S>(view), box);
        const Download elements = commands.download(box, 0, bytes);
        std::memcpy(values.data(), elements.get().data(), bytes);
        return values;
    }

    Extent domain_;
    std::vector<Element> values_;
};

/// The addresses of the domain that lie in blocks of the size `size`. `first` gives the first address of a block, or
/// nullopt if there is no such block. Of blocks with more than 2^17 addresses in all a sample at a regular step.
template <class A, class Count, class First>
std::vector<A> addresses_in_blocks(const Count& count, const First& first, const A& size, const A& domain) {
    std::vector<A> addresses;
    const Extent extent = detail::extent_of(size), limit = detail::extent_of(domain);
    const std::uint64_t volume = detail::volume_of(extent);
    const std::uint64_t most = volume == 0 ? 1 : std::max<std::uint64_t>((1u << 17) / volume, 1);
    try {
        const std::uint64_t blocks = count(), step = (blocks + most - 1) / most;
        for (std::uint64_t block = 0; block < blocks; block += step) {
            const std::optional<A> begin = first(static_cast<std::uint32_t>(block));
            for (std::uint64_t i = 0; begin && i < std::min<std::uint64_t>(volume, 1u << 17); ++i) {
                Extent at = detail::extent_of(*begin, 0);
                const Extent inside = detail::address_of(i, extent);
                for (unsigned axis = 0; axis < detail::Axes<A>::count; ++axis) at[axis] += inside[axis];
                if (detail::is_within(limit, at)) addresses.push_back(detail::address_from<A>(at));
            }
        }
    } catch (const OutsideTable&) {}
    return addresses;
}

/// What is known about a translator's mapping.
enum class Mapping {
    one_to_one,   ///< declared by @one_to_one or `invert`
    many_to_one,  ///< declared by @many_to_one
    undeclared,
    by_tables,  ///< undeclared and total; the tables that the translator reads decide
};

namespace detail {

/// A virtual address and the physical one that it maps to.
struct Translated {
    Extent physical, address;
};

struct TranslatorText {
    const std::string& name;
    const std::string& domain;
    unsigned rank, physical_rank;
};

/// Whether no two addresses map to the same physical one. Reports the first few that do to `test`, unless the
/// translator is declared many-to-one; notes one pair if tables decide. Sorts `all` by physical address.
GLIFT_API bool is_one_to_one(Test& test, const TranslatorText& text, Mapping mapping, std::vector<Translated>& all);
/// Whether all physical addresses lie inside the memory. Reports the first few that do not to `test`.
GLIFT_API bool is_inside(Test& test, const TranslatorText& text, const Extent& memory,
                         const std::vector<Translated>& all);
GLIFT_API void fail_inverse(Test& test, const TranslatorText& text, const Extent& address, const Extent& back);

/// A memory's extent. Addresses have 32 bits, so a larger buffer's extent is clamped.
template <class E> Extent limit_of(const E& extent) {
    if constexpr (std::is_same_v<E, std::uint64_t>)
        return extent_of(static_cast<uint>(std::min<std::uint64_t>(extent, 0xffffffffu)));
    else return extent_of(extent);
}

}  // namespace detail

/// Checks one translator with the state that a structure gives it: `invert`, if it is not null, undoes `translate`; no
/// two addresses map to the same one, unless @many_to_one says so; and all lie inside the memory that the physical
/// addresses are of, if there is one (not null). A mapping by tables may map several to one: then this is noted.
/// Returns the physical addresses, each once.
template <class A, class Translate, class Invert>
auto check_translator(Test& test, const std::string& name, const Tried<A>& from, const Translate& translate,
                      const Invert& invert, Mapping mapping, const Extent* memory) {
    using Physical = std::remove_cvref_t<decltype(*translate(A{}))>;
    const detail::TranslatorText text{name, from.domain, detail::Axes<A>::count, detail::Axes<Physical>::count};
    Tried<Physical> result{{}, from.domain, from.complete};
    std::vector<detail::Translated> all;
    for (const A& address : from.addresses) {
        std::optional<Physical> physical;
        try {
            physical = translate(address);
        } catch (const OutsideTable&) {}
        if (!physical) {
            result.complete = false;
            continue;
        }
        all.push_back({detail::extent_of(*physical, 0), detail::extent_of(address, 0)});
        if constexpr (!std::is_same_v<Invert, std::nullptr_t>) {
            try {
                const Extent back = detail::extent_of(A(invert(*physical)), 0);
                if (back != all.back().address && test.failures.size() <= 3)
                    detail::fail_inverse(test, text, all.back().address, back);
            } catch (const OutsideTable&) {}
        }
    }
    const bool one_to_one = detail::is_one_to_one(test, text, mapping, all);
    const bool inside = memory == nullptr || detail::is_inside(test, text, *memory, all);
    result.complete = result.complete && one_to_one && inside;
    for (const detail::Translated& one : all) {
        if (result.addresses.empty() || detail::extent_of(result.addresses.back(), 0) != one.physical)
            result.addresses.push_back(detail::address_from<Physical>(one.physical));
    }
    return result;
}

/// True if the whole domain was tested and mapped one-to-one, and all physical addresses lie inside the memory, whose
/// extent is `extent`.
template <class P, class E> bool fill_memory(const Tried<P>& reached, const E& extent) {
    const Extent limit = detail::limit_of(extent);
    return reached.complete && std::ranges::all_of(reached.addresses, [&](const P& address) {
               return detail::is_within(limit, detail::extent_of(address, 0));
           });
}

}  // namespace glift
