// Makes the Part of a structure of any generated class, through the class's `visit_state`.
#pragma once

#include <glift/files/part.h>

#include <cstring>
#include <utility>

namespace glift::files {

template <class S> Part part_of(S& structure, std::string name, Role role);

template <class E> ExtentField extent_field(E& extent) {
    if constexpr (std::is_same_v<E, std::uint64_t>) return {&extent, 1, true};
    else return {&extent, detail::Axes<E>::count, false};
}

/// The visitor of `visit_state`.
class Collector {
public:
    explicit Collector(Part& part) : part_(part) {}

    template <class T> void argument(const char* name, T& value) {
        part_.values.push_back({name, true, &value, element_type<T>()});
    }
    template <class T> void host(const char* name, T& value) {
        part_.values.push_back({name, false, &value, element_type<T>()});
    }
    /// `former`: the name with the former names of fields.
    template <class E, class T>
    void buffer(const char* name, Memory& memory, E& extent, const T&, const char* former = nullptr) {
        const std::string all = name, all_former = former ? former : name;
        const std::size_t dot = all.find('.');
        const std::string declared = all.substr(0, dot);
        ElementType type = element_type<T>();
        if (dot != std::string::npos)
            for (Field& field : type.fields)
                field.name = all.substr(dot + 1), field.former = all_former.substr(dot + 1);
        if (part_.memories.empty() || part_.memories.back().name != declared)
            part_.memories.push_back({declared, false, {}});
        part_.memories.back().planes.push_back({&memory, extent_field(extent), std::move(type)});
    }
    template <class E> void image(const char* name, Memory& memory, E& extent) {
        part_.memories.push_back({name, true, {{&memory, extent_field(extent), {}}}});
    }
    template <class S> void member(const char* name, S& structure) { add(name, structure, Role::member); }
    template <class S> void base(const char* name, S& structure) { add(name, structure, Role::base); }
    template <class S> void given(const char* name, S& structure) { add(name, structure, Role::given); }

private:
    template <class S> void add(const char* name, S& structure, Role role) {
        part_.parts.push_back(part_of(structure, name, role));
    }
    Part& part_;
};

template <class A> A address_of(const Extent& extent) {
    A address{};
    if constexpr (detail::Axes<A>::count == 1) address = extent[0];
    else
        for (unsigned i = 0; i < detail::Axes<A>::count; ++i) address[i] = extent[i];
    return address;
}

/// Whether the element at address a lies at the row-major index of a. The map is affine (HasRows), so that its values
/// at zero and at one step along each axis say so.
template <class S> bool is_row_major(const S& structure) {
    if constexpr (detail::HasRows<S>) {
        constexpr unsigned rank = detail::Axes<typename S::Address>::count;
        const Extent extent = detail::extent_of(structure.domain());
        if (structure.place({}) != 0) return false;
        std::uint64_t stride = 1;
        for (unsigned axis = 0; axis < rank; stride *= extent[axis++]) {
            Extent step{};
            step[axis] = 1;
            if (extent[axis] > 1 && structure.place(address_of<typename S::Address>(step)) != stride) return false;
        }
        return true;
    } else return false;
}

/// Structures whose elements can be read and written by address, and are all resident.
template <class S>
concept IsDense = !detail::HasList<S> && requires(S & s, std::vector<typename S::Element> values) {
    {s.device()};
    values = s.read({}, {});
    s.write({}, {}, values);
    s.copy_in(s.device(), Range<S>(s), Memory());
};

template <IsDense S> Elements elements_of(S& structure) {
    using A = typename S::Address;
    using T = typename S::Element;
    Elements elements;
    elements.rank = detail::Axes<A>::count;
    elements.is_row_major = is_row_major(structure);
    elements.type = element_type<T>();
    elements.domain = [&structure] { return detail::extent_of(structure.domain()); };
    elements.read = [&structure](const Extent& origin, const Extent& size, std::vector<std::byte>& to) {
        const std::vector<T> values = structure.read(address_of<A>(origin), address_of<A>(size));
        to.resize(values.size() * sizeof(T));
        std::memcpy(to.data(), values.data(), to.size());
    };
    elements.write = [&structure](const Extent& origin, const Extent& size, std::span<const std::byte> from) {
        std::vector<T> values(from.size() / sizeof(T));
        std::memcpy(values.data(), from.data(), from.size());
        structure.write(address_of<A>(origin), address_of<A>(size), values);
    };
    return elements;
}

template <class S> Part part_of(S& structure, std::string name, Role role) {
    Part part;
    part.name = std::move(name);
    part.type = S::type_name;
    part.key = S::state_key;
    part.role = role;
    structure.visit_state(Collector(part));
    if constexpr (IsDense<S>) {
        const bool has_buffers = !part.memories.empty() && !part.memories[0].is_image;
        if (has_buffers) part.elements = elements_of(structure);
    }
    return part;
}

}  // namespace glift::files
