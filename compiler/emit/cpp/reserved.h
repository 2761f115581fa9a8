// Names that generated code must not declare, since C++, its libraries or systems use them.
#pragma once

#include <string_view>

namespace gliftc::cpp {

/// Whether it is a keyword of C++, or a name that generated code uses without a scope: std, glift, uint, float4.
bool is_word(std::string_view name);

/// Whether it is a macro of C's, C++'s or POSIX's headers, of compilers, of Windows, or of the runtime's, Vulkan's or
/// oneTBB's headers: macros know no scopes.
bool is_macro(std::string_view name);

/// Whether it is a function, type or variable that C's or POSIX's headers declare outside of namespaces, or main.
bool is_global(std::string_view name);

}  // namespace gliftc::cpp
