// Values of any type as text and as numbers, and JSON: what inspect.h writes.
#pragma once

#include <glift/box.h>
#include <glift/vector.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace glift::detail {

// ------------------------------------------------------------------------------------------------------------- JSON

inline std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        if (static_cast<unsigned char>(c) >= 32) result += c;
    }
    return result + "\"";
}

/// A JSON object, with its members in the order in which they were put.
class JsonObject {
public:
    void put(const std::string& name, const std::string& json) {
        text_ += (text_.empty() ? "" : ",\n") + quoted(name) + ": " + json;
    }
    void put(const std::string& name, std::uint64_t number) { put(name, std::to_string(number)); }
    std::string text() const { return "{" + text_ + "}"; }

private:
    std::string text_;
};

inline std::string json_list(const std::vector<std::string>& items) {
    std::string text;
    for (const std::string& item : items) text += (text.empty() ? "" : ",\n") + item;
    return "[" + text + "]";
}

inline std::string json_extent(const Extent& extent, unsigned rank) {
    std::string text;
    for (unsigned i = 0; i < rank; ++i) text += (i ? ", " : "") + std::to_string(extent[i]);
    return "[" + text + "]";
}

/// Numbers as little-endian 32-bit words in base 64.
template <class N> std::string json_numbers(const std::vector<N>& numbers) {
    static_assert(sizeof(N) == 4);
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<unsigned char> bytes(numbers.size() * 4);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::uint32_t word;
        std::memcpy(&word, &numbers[i], 4);
        for (unsigned k = 0; k < 4; ++k) bytes[4 * i + k] = static_cast<unsigned char>(word >> 8 * k);
    }
    std::string text = "\"";
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < n ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= n ? digits[three >> (18 - 6 * k) & 63u] : '=';
    }
    return text + "\"";
}

// ------------------------------------------------------------------------------------------------------------ values

template <class T> inline constexpr unsigned components_of = 0;
template <class T>
requires std::is_arithmetic_v<T>
inline constexpr unsigned components_of<T> = 1;
template <class T, unsigned N> inline constexpr unsigned components_of<vec<T, N>> = N;

/// A visitor for `describe` of generated classes that ignores all parts: the base of visitors that look at some parts.
struct SeesNothing {
    template <class... Parts> void value(const Parts&...) {}
    template <class... Parts> void memory(const Parts&...) {}
    template <class... Parts> void member(const Parts&...) {}
    template <class... Parts> void given(const Parts&...) {}
};

template <class T>
concept Described = requires(const T& x, SeesNothing see) {
    x.describe(see);
};

/// What printf writes for `%.<digits>g`, in any locale with a decimal point.
GLIFT_API std::string number_text(double value, int digits);

template <class T> std::string text_of_value(const T& value);

struct FieldTexts : SeesNothing {
    template <class T> void value(const char* name, const T& field) {
        text += (text.empty() ? "" : ", ") + std::string(name) + " " + text_of_value(field);
    }
    std::string text;
};

template <class T> std::string text_of_value(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
        return value ? "true" : "false";
    } else if constexpr (std::is_floating_point_v<T>) {
        return number_text(static_cast<double>(value), 7);
    } else if constexpr (std::is_arithmetic_v<T>) {
        return std::to_string(value);
    } else if constexpr (components_of<T> > 1) {
        std::string text;
        for (unsigned i = 0; i < components_of<T>; ++i) text += (i ? ", " : "") + text_of_value(value[i]);
        return "{" + text + "}";
    } else if constexpr (Described<T>) {
        FieldTexts fields;
        value.describe(fields);
        return fields.text;
    } else if constexpr (requires {
                             value.has_value();
                             *value;
                         }) {
        return value ? text_of_value(*value) : "none";
    } else if constexpr (requires { static_cast<double>(value); }) {
        return text_of_value(static_cast<double>(value));
    } else {
        return "(" + std::to_string(sizeof(T)) + " bytes)";
    }
}

template <class T> double number_of(const T& value);

/// Finds the number (number_of) of a struct's first field.
struct FirstNumber : SeesNothing {
    template <class T> void value(const char*, const T& field) {
        if (!is_found) number = number_of(field);
        is_found = true;
    }
    double number = 0;
    bool is_found = false;
};

/// The number that a picture shows for a value: a scalar itself, the number of a vector's first component or of a
/// struct's first field; 0 for other types.
template <class T> double number_of(const T& value) {
    if constexpr (components_of < T >> 1) {
        return number_of(value[0]);
    } else if constexpr (Described<T>) {
        FirstNumber first;
        value.describe(first);
        return first.number;
    } else if constexpr (requires { static_cast<double>(value); }) {
        return static_cast<double>(value);
    } else {
        return 0;
    }
}

}  // namespace glift::detail
