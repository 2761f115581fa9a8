#include "message_text.h"

#include <glift/half.h>

#include <bit>
#include <charconv>
#include <cmath>

namespace glift::detail {

namespace {

/// Calls text(part) for each part of the format between placeholders, and place(what) for each placeholder: `f`,
/// `e 0=red`.
template <class Text, class Place> void for_each_part(std::string_view format, Text&& text, Place&& place) {
    for (std::size_t i = 0; i < format.size(); ++i) {
        const char letter = format[i];
        const bool is_double = i + 1 < format.size() && format[i + 1] == letter;
        if (letter == '{' && !is_double) {
            const std::size_t end = format.find('}', i);
            place(format.substr(i + 1, end - i - 1));
            i = end;
            continue;
        }
        text(format.substr(i, 1));
        if (letter == '{' || letter == '}') ++i;
    }
}

std::uint32_t words_of_place(std::string_view place) { return place == "d" || place == "I" || place == "U" ? 2 : 1; }

/// NaNs have no sign in messages, since devices give them different ones.
template <class Float> std::string float_text(Float value) {
    if (std::isnan(value)) return "nan";
    char text[64];
    return {text, std::to_chars(text, std::end(text), value).ptr};
}

/// As few digits as a half needs: a float that is one has more.
std::string half_text(float value) {
    if (std::isnan(value)) return "nan";
    char text[64];
    for (int digits = 1;; ++digits) {
        char* const end = std::to_chars(text, std::end(text), value, std::chars_format::general, digits).ptr;
        float back = 0;
        std::from_chars(text, end, back);
        if (digits == 9 || static_cast<float>(half(back)) == value) return {text, end};
    }
}

std::string enum_text(std::string_view enumerators, std::uint32_t value) {
    const std::string wanted = " " + std::to_string(value) + "=";
    const std::size_t at = enumerators.find(wanted);
    if (at == enumerators.npos) return std::to_string(value);
    const std::string_view name = enumerators.substr(at + wanted.size());
    return std::string(name.substr(0, name.find(' ')));
}

std::string scalar_text(std::string_view place, const std::uint32_t* words) {
    const std::uint32_t word = words[0];
    const auto both = [&] { return std::uint64_t{words[1]} << 32 | words[0]; };
    switch (place[0]) {
    case 'b': return word != 0 ? "true" : "false";
    case 'i': return std::to_string(static_cast<std::int32_t>(word));
    case 'f': return float_text(std::bit_cast<float>(word));
    case 'h': return half_text(std::bit_cast<float>(word));
    case 'd': return float_text(std::bit_cast<double>(both()));
    case 'I': return std::to_string(static_cast<std::int64_t>(both()));
    case 'U': return std::to_string(both());
    case 'e': return enum_text(place.substr(1), word);
    default: return std::to_string(word);
    }
}

}  // namespace

std::uint32_t words_of_format(std::string_view format) {
    std::uint32_t words = 0;
    for_each_part(
        format, [](std::string_view) {}, [&](std::string_view place) { words += words_of_place(place); });
    return words;
}

std::string filled_format(std::string_view format, std::span<const std::uint32_t> words) {
    std::string text;
    const std::uint32_t* next = words.data();
    for_each_part(
        format, [&](std::string_view part) { text += part; },
        [&](std::string_view place) {
            text += scalar_text(place, next);
            next += words_of_place(place);
        });
    return text;
}

}  // namespace glift::detail
