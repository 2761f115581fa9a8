// Names that generated code must not declare, since C++, its libraries or systems use them.
#pragma once

#include <string_view>

namespace gliftc::cpp {

/// A keyword of C++, or what generated code names without a scope: std, glift, uint, float4.
bool is_word(std::string_view name);

/// A macro of C's, C++'s or POSIX' headers, of compilers, of the runtime's headers: macros know no scopes.
bool is_macro(std::string_view name);

/// A function, type or variable that C's or POSIX' headers declare outside of namespaces.
bool is_global(std::string_view name);

}  // namespace gliftc::cpp
