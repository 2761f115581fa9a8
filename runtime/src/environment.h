// Environment variables. An invalid value is an error, never ignored.
#pragma once

#include <cstdint>
#include <string_view>

namespace glift::detail {

/// True if the variable is 1; throws wrong_argument for a value other than 0, 1 or nothing.
bool environment_flag(const char* name);

/// Parses a number of bytes: digits, then nothing or K, M, G or T for powers of 1024 (`2G`, also `2GiB`, `2GB`).
/// Throws wrong_argument that names the variable.
std::uint64_t bytes_of_text(const char* name, std::string_view text);

/// GLIFT_MEMORY_LIMIT, or no limit.
std::uint64_t memory_limit();

}  // namespace glift::detail
