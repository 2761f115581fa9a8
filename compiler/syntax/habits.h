// What programmers bring along from C, C++, GLSL, HLSL, Rust and Python, and how Glift says it.
#pragma once

#include <string>
#include <string_view>

namespace gliftc {

/// The remedy where a name is one of another language; empty: it is none that we know.
std::string hint_for_name(std::string_view name);

/// The same for a word where a declaration should begin.
std::string hint_for_declaration(std::string_view word);

/// The same for what stands behind a '#'.
std::string hint_for_directive(std::string_view word);

}  // namespace gliftc
