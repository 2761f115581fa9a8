#include "emit/cpp/reserved.h"

#include <algorithm>
#include <array>
#include <cstdint>

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
    "if",
    "inline",
    "int",
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
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "requires",
    "return",
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

constexpr auto macros = std::to_array<std::string_view>({
#include "emit/cpp/macros.inc"
});

constexpr auto globals = std::to_array<std::string_view>({
#include "emit/cpp/globals.inc"
});

/// Macros of other compilers and systems than those on which tools/cpp-names wrote the tables.
constexpr auto other_macros = std::to_array<std::string_view>({
    "CALLBACK",
    "CONST",
    "ERROR",
    "FALSE",
    "IN",
    "OPTIONAL",
    "OUT",
    "TRUE",
    "VOID",
    "WINAPI",
    "cdecl",
    "far",
    "huge",
    "i386",
    "near",
    "pascal",
    "sun",
});

static_assert(std::ranges::is_sorted(words));
static_assert(std::ranges::is_sorted(macros));
static_assert(std::ranges::is_sorted(globals));
static_assert(std::ranges::is_sorted(other_macros));

/// For each first character, a bit for each length that some name of the table with this first character has (bit 63:
/// 63 or more). For most names that are not in the table, these bits alone show that they are not.
template <std::size_t n>
constexpr std::array<std::uint64_t, 128> lengths_of(const std::array<std::string_view, n>& names) {
    std::array<std::uint64_t, 128> lengths{};
    for (std::string_view name : names)
        lengths[static_cast<unsigned char>(name[0])] |= std::uint64_t{1} << std::min<std::size_t>(name.size(), 63);
    return lengths;
}

template <const auto& names> bool holds(std::string_view name) {
    static constexpr auto lengths = lengths_of(names);
    if (name.empty() || static_cast<unsigned char>(name[0]) > 127) return false;
    const bool may = lengths[static_cast<unsigned char>(name[0])] >> std::min<std::size_t>(name.size(), 63) & 1;
    return may && std::ranges::binary_search(names, name);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// float4, float3x3 and the like: names such as the runtime's vectors and matrices have.
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

/// Whether the name begins as most macros of the runtime, of Vulkan's headers and of oneTBB's do: there are too many of
/// them for a table.
bool begins_as_macro(std::string_view name) {
    return name.starts_with("GLIFT_") || name.starts_with("VK_") || name.starts_with("TBB") ||
           name.starts_with("ONETBB");
}

}  // namespace

bool is_word(std::string_view name) { return holds<words>(name) || is_type_name(name); }

bool is_macro(std::string_view name) {
    return holds<macros>(name) || holds<other_macros>(name) || begins_as_macro(name);
}

bool is_global(std::string_view name) { return name == "main" || holds<globals>(name); }

}  // namespace gliftc::cpp
