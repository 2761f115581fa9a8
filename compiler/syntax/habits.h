// Hints for names and syntax of C, C++, GLSL, HLSL, Rust and Python: what Glift uses instead.
#pragma once

#include <string>
#include <string_view>

namespace gliftc {

/// The hint for a name of another language; empty if there is none.
std::string hint_for_name(std::string_view name);

/// The same for a word in place of a declaration.
std::string hint_for_declaration(std::string_view word);

/// The same for a preprocessor directive.
std::string hint_for_directive(std::string_view word);

}  // namespace gliftc
