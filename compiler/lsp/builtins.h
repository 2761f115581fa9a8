// What the language itself names: types, functions, access patterns, words of declarations.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gliftc::lsp {

struct BuiltinFunction {
    std::string_view name;
    std::vector<std::string> parameters;  ///< kinds of types: "floating", "number or scalar"
    std::string result;

    std::string signature() const;  ///< mix(floating, floating, floating or scalar) -> floating
};

const std::vector<BuiltinFunction>& builtin_functions();
const BuiltinFunction* find_builtin_function(std::string_view name);

/// Types, texel formats, shapes of memory and constraints.
const std::vector<std::string_view>& builtin_types();

struct Pattern {
    std::string_view name;
    std::string_view text;  ///< what it does, in a sentence
};
const std::vector<Pattern>& patterns();

/// Keywords and the words that begin declarations, items and statements.
const std::vector<std::string_view>& keywords();

/// The functions that every structure has, where its kind allows them.
const std::vector<std::string_view>& structure_methods();

}  // namespace gliftc::lsp
