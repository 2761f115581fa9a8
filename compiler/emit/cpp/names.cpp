#include "emit/cpp/names.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace gliftc::cpp {

namespace {

constexpr auto words = std::to_array<std::string_view>({
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "call",
    "case",
    "catch",
    "char",
    "char16_t",
    "char32_t",
    "char8_t",
    "class",
    "co_await",
    "co_return",
    "co_yield",
    "commands",
    "compl",
    "concept",
    "const",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "continue",
    "decltype",
    "default",
    "delete",
    "device",
    "do",
    "double",
    "dynamic_cast",
    "else",
    "enum",
    "explicit",
    "export",
    "extern",
    "false",
    "float",
    "for",
    "friend",
    "glift",
    "goto",
    "half",
    "host",
    "if",
    "inline",
    "int",
    "linux",
    "long",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "parameters",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "requires",
    "return",
    "row",
    "short",
    "signed",
    "sizeof",
    "static",
    "static_assert",
    "static_cast",
    "std",
    "struct",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "uint",
    "union",
    "unix",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
});

/// How long the words are that begin with each character, a bit a length: most names are told from words by it.
constexpr auto lengths_of_words = [] {
    std::array<std::uint32_t, 128> lengths{};
    for (std::string_view word : words) lengths[static_cast<unsigned char>(word[0])] |= 1u << word.size();
    return lengths;
}();

bool may_be_word(std::string_view name) {
    if (name.empty() || name.size() > 31 || static_cast<unsigned char>(name[0]) > 127) return false;
    return lengths_of_words[static_cast<unsigned char>(name[0])] >> name.size() & 1;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// float4, uint3x3 and the like: types of the language.
bool is_type_name(std::string_view name) {
    if (name.empty() || !is_digit(name.back())) return false;
    for (std::string_view scalar : {"bool", "int", "uint", "float", "half", "double"}) {
        if (!name.starts_with(scalar)) continue;
        std::string_view rest = name.substr(scalar.size());
        if (rest.size() == 1 && is_digit(rest[0])) return true;
        if (rest.size() == 3 && is_digit(rest[0]) && rest[1] == 'x' && is_digit(rest[2])) return true;
    }
    return false;
}

static_assert(std::ranges::is_sorted(words));

}  // namespace

bool is_reserved(std::string_view name) {
    return (may_be_word(name) && std::ranges::binary_search(words, name)) || is_type_name(name);
}

std::string identifier(std::string_view text) {
    std::string result;
    result.reserve(text.size() + 1);
    for (char c : text) {
        if (is_letter(c) || is_digit(c)) result += c;
        else if (!result.ends_with('_')) result += '_';
    }
    while (result.size() > 1 && result.ends_with('_')) result.pop_back();
    if (result.empty() || is_digit(result[0])) result.insert(0, "n");
    if (result[0] == '_') result.insert(0, "n");
    if (is_reserved(result)) result += '_';
    return result;
}

void Scopes::leave() {
    for (const std::string* name : scopes_.back()) used_.erase(used_.find(*name));
    scopes_.pop_back();
}

std::string Scopes::declare(std::string_view wanted) {
    std::string name = identifier(wanted);
    auto [place, is_new] = used_.insert(name);
    if (!is_new) {
        const std::string stem = name.ends_with('_') ? name : name + "_";
        for (int i = 2; !is_new; ++i) std::tie(place, is_new) = used_.insert(name = stem + std::to_string(i));
    }
    scopes_.back().push_back(&*place);
    return name;
}

}  // namespace gliftc::cpp
