// Types of elements and values, taken apart into the fields that files store: numbers, and vectors, matrices and arrays
// of numbers. No type is known by name: structs list their fields themselves (`describe`).
#pragma once

#include <glift/half.h>
#include <glift/inspected_values.h>
#include <glift/vector.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace glift::files {

/// A number as it lies in memory. `boolean` has four bytes, 0 or 1; `flag` is a C++ bool, one byte.
enum class Scalar : std::uint8_t {
    boolean,
    flag,
    int8,
    int16,
    int32,
    int64,
    uint8,
    uint16,
    uint32,
    uint64,
    float16,
    float32,
    float64
};

/// A part of an element that is no struct.
struct Field {
    std::string name;  ///< `a.velocity`: the path to it; empty: the element itself
    Scalar scalar = Scalar::uint8;
    std::uint32_t offset = 0;          ///< in bytes from the begin of the element
    std::vector<std::uint32_t> shape;  ///< {}: a number; {3}: a vector or array; {4, 3}: four vectors of three
    std::string former;                ///< the path in files that were saved before a field was renamed (`@was`)
    std::uint32_t numbers() const {
        std::uint32_t count = 1;
        for (std::uint32_t length : shape) count *= length;
        return count;
    }
    bool operator==(const Field&) const = default;
};

struct ElementType {
    std::uint32_t bytes = 0;
    std::vector<Field> fields;
};

template <class T> constexpr Scalar scalar_of() {
    if constexpr (std::is_same_v<T, Bool>) return Scalar::boolean;
    else if constexpr (std::is_same_v<T, bool>) return Scalar::flag;
    else if constexpr (std::is_same_v<T, half>) return Scalar::float16;
    else if constexpr (std::is_floating_point_v<T>) return sizeof(T) == 4 ? Scalar::float32 : Scalar::float64;
    else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
        constexpr bool is_signed = [] {
            if constexpr (std::is_enum_v<T>) return std::is_signed_v<std::underlying_type_t<T>>;
            else return std::is_signed_v<T>;
        }();
        if constexpr (sizeof(T) == 1) return is_signed ? Scalar::int8 : Scalar::uint8;
        else if constexpr (sizeof(T) == 2) return is_signed ? Scalar::int16 : Scalar::uint16;
        else if constexpr (sizeof(T) == 4) return is_signed ? Scalar::int32 : Scalar::uint32;
        else return is_signed ? Scalar::int64 : Scalar::uint64;
    } else return Scalar::uint8;
}

/// The numbers of a type that is no struct: their type, and how many along each axis. Types that are not the
/// language's are bytes.
template <class T> struct Numbers {
    using Number = T;
    static constexpr bool is_number =
        std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, half> || std::is_same_v<T, Bool>;
    static std::vector<std::uint32_t> shape() {
        if (is_number) return {};
        return {static_cast<std::uint32_t>(sizeof(T))};
    }
};
template <class Part, class Whole> std::vector<std::uint32_t> shape_of_parts() {
    std::vector<std::uint32_t> shape = Numbers<Part>::shape();
    shape.insert(shape.begin(), static_cast<std::uint32_t>(sizeof(Whole) / sizeof(Part)));
    return shape;
}
template <class T, unsigned N> struct Numbers<vec<T, N>> {
    using Number = typename Numbers<T>::Number;
    static std::vector<std::uint32_t> shape() { return shape_of_parts<T, vec<T, N>>(); }
};
template <class T, unsigned C, unsigned R> struct Numbers<mat<T, C, R>> {
    using Number = T;
    static std::vector<std::uint32_t> shape() { return shape_of_parts<vec<T, R>, mat<T, C, R>>(); }
};
template <class T, unsigned N> struct Numbers<array<T, N>> {
    using Number = typename Numbers<T>::Number;
    static std::vector<std::uint32_t> shape() { return shape_of_parts<T, array<T, N>>(); }
};

template <class T> inline constexpr bool is_array_of_structs = false;
template <class T, unsigned N> inline constexpr bool is_array_of_structs<array<T, N>> =
    detail::Described<T> || is_array_of_structs<T>;

/// The name that a field of T had before (`@was`).
template <class T> std::string former_name(const std::string& name) {
    if constexpr (requires { T::former_names; })
        for (const auto& names : T::former_names)
            if (name == names[0]) return names[1];
    return name;
}

/// Lists the fields of an element in the order of their declaration.
class FieldList {
public:
    explicit FieldList(const void* element) : begin_(static_cast<const std::byte*>(element)) {}

    template <class T> void add(const std::string& name, const std::string& former, const T& value) {
        if constexpr (detail::Described<T>) {
            value.describe(Inner<T>{*this, name.empty() ? "" : name + ".", former.empty() ? "" : former + "."});
        } else if constexpr (is_array_of_structs<T>) {
            for (unsigned i = 0; i < T::size(); ++i) {
                const std::string index = "[" + std::to_string(i) + "]";
                add(name + index, former + index, value.values[i]);
            }
        } else {
            const auto offset = reinterpret_cast<const std::byte*>(&value) - begin_;
            fields.push_back({name, scalar_of<typename Numbers<T>::Number>(), static_cast<std::uint32_t>(offset),
                              Numbers<T>::shape(), former});
        }
    }

    std::vector<Field> fields;

private:
    /// The visitor of `describe` of a struct T.
    template <class T> struct Inner : detail::SeesNothing {
        Inner(FieldList& list, std::string before, std::string before_former)
            : owner(list), prefix(std::move(before)), former_prefix(std::move(before_former)) {}
        template <class F> void value(const char* name, const F& field) {
            owner.add(prefix + name, former_prefix + former_name<T>(name), field);
        }
        FieldList& owner;
        std::string prefix, former_prefix;
    };

    const std::byte* begin_;
};

template <class T> ElementType element_type() {
    const T element{};
    FieldList list(&element);
    list.add("", "", element);
    return {static_cast<std::uint32_t>(sizeof(T)), std::move(list.fields)};
}

}  // namespace glift::files
