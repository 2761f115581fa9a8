// Checks of translators, which `gliftc test` makes without being asked.
#pragma once

#include <glift/testing.h>

#include <algorithm>
#include <utility>

namespace glift {

/// Addresses that a translator is tried with: all of a small domain, else a spread.
template <class A> struct Tried {
    std::vector<A> addresses;
    std::string domain;    ///< of the structure, in words
    bool complete = true;  ///< these are all there are, each is mapped so far, and no two have met
};

template <class A> Tried<A> tried(const A& domain) {
    constexpr unsigned rank = detail::Axes<A>::count;
    const Extent extent = detail::extent_of(domain);
    const std::uint64_t volume = detail::volume_of(extent);
    const std::uint64_t step = volume <= 1u << 17 ? 1 : volume / 20000 | 1;
    Tried<A> result{{}, detail::text_of(extent, rank), step == 1};
    for (std::uint64_t i = 0; i < volume; i += step)
        result.addresses.push_back(detail::address_from<A>(detail::address_of(i, extent)));
    return result;
}

/// Thrown where a translator reads beyond a table: what it finds there is the table's affair.
struct OutsideTable {};

/// What a table holds, on the host: translators that read it are checked with it.
template <class S> class Mirror {
public:
    using Address = typename S::Address;
    using Element = typename S::Element;

    explicit Mirror(const S& table) : domain_(detail::extent_of(table.domain())) {
        if (detail::volume_of(domain_) > 1u << 22)
            throw Error(ErrorCode::too_large, std::string("a table too large to look through: ") + S::type_name);
        values_ = table.read();
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
    Extent domain_;
    std::vector<Element> values_;
};

namespace detail {

/// A virtual address and the physical one that it has.
struct Translated {
    Extent physical, address;
};

/// Reports those that meet. True if none do.
inline bool are_apart(Test* test, const std::string& name, std::vector<Translated>& all, unsigned rank,
                      unsigned physical_rank, const std::string& domain) {
    std::ranges::sort(all, {}, [](const Translated& one) { return std::pair(one.physical, one.address); });
    bool apart = true;
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (all[i].physical != all[i - 1].physical) continue;
        apart = false;
        if (!test || test->failures.size() > 3) break;
        test->failures.push_back(name + ": not one-to-one: " + text_of(all[i - 1].address, rank) + " and " +
                                 text_of(all[i].address, rank) + " both map to " +
                                 text_of(all[i].physical, physical_rank) + " (domain " + domain + ")");
    }
    return apart;
}

}  // namespace detail

/// Checks one translator with the state that a structure gives it: what it maps an address to maps back, and, where it
/// is said to be one-to-one, no two addresses map to one. Returns where the addresses lead.
template <class A, class Translate, class Invert>
auto check_translator(Test& test, const std::string& name, const Tried<A>& from, const Translate& translate,
                      const Invert& invert, bool is_claimed_one_to_one) {
    using Physical = std::remove_cvref_t<decltype(*translate(A{}))>;
    constexpr unsigned rank = detail::Axes<A>::count, physical_rank = detail::Axes<Physical>::count;
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
            const Extent back = detail::extent_of(A(invert(*physical)), 0);
            if (back != all.back().address && test.failures.size() <= 3)
                test.failures.push_back(name + ": invert(translate(" + detail::text_of(all.back().address, rank) +
                                        ")) is " + detail::text_of(back, rank) + " (domain " + from.domain + ")");
        }
    }
    const bool apart =
        detail::are_apart(is_claimed_one_to_one ? &test : nullptr, name, all, rank, physical_rank, from.domain);
    result.complete = result.complete && apart;
    for (const detail::Translated& one : all) {
        if (result.addresses.empty() || detail::extent_of(result.addresses.back(), 0) != one.physical)
            result.addresses.push_back(detail::address_from<Physical>(one.physical));
    }
    return result;
}

/// True if the addresses are all of a domain, each by itself, in a memory that has them all. Addresses that are tried
/// have 32 bits: of more elements than these reach, a buffer has enough.
template <class P, class E> bool fill_memory(const Tried<P>& reached, const E& extent) {
    Extent limit{};
    if constexpr (std::is_same_v<E, std::uint64_t>)
        limit = detail::extent_of(static_cast<uint>(std::min<std::uint64_t>(extent, 0xffffffffu)));
    else limit = detail::extent_of(extent);
    return reached.complete && std::ranges::all_of(reached.addresses, [&](const P& address) {
               const Extent at = detail::extent_of(address, 0);
               for (unsigned axis = 0; axis < 4; ++axis)
                   if (at[axis] >= limit[axis]) return false;
               return true;
           });
}

}  // namespace glift
