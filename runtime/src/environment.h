// Environment variables. A value that is none of those allowed is an error, not a guess.
#pragma once

#include <cstdint>
#include <string_view>

namespace glift::detail {

/// Set and neither empty nor 0. Throws wrong_argument unless it is 0 or 1.
bool environment_flag(const char* name);

/// The bytes that the text says: digits, then nothing or K, M, G or T for powers of 1024 (`2G`, also `2GiB`, `2GB`).
/// Throws wrong_argument in the name of the variable.
std::uint64_t bytes_of_text(const char* name, std::string_view text);

/// GLIFT_MEMORY_LIMIT, or no limit.
std::uint64_t memory_limit();

}  // namespace glift::detail
