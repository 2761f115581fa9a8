// Hints in error messages for users of C, C++, CUDA, GLSL, HLSL, Rust and Python: what Glift has in place of names and
// syntax of those languages.
#pragma once

#include <string>
#include <string_view>

namespace gliftc {

/// The hint for a name of another language; empty if there is none.
std::string hint_for_name(std::string_view name);

/// The hint for a word of another language where a declaration is expected; empty if there is none.
std::string hint_for_declaration(std::string_view word);

/// The hint for the name of a preprocessor directive; empty if there is none.
std::string hint_for_directive(std::string_view word);

}  // namespace gliftc
