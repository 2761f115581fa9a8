// The compiler's version, which CMake defines.
#pragma once

#include <string_view>

namespace gliftc {

/// `0.1.0`.
std::string_view version();

/// The first two numbers of the version: generated code needs the runtime of the same ones.
std::string_view major_version();
std::string_view minor_version();

}  // namespace gliftc
