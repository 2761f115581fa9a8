// Environment variables that are switches or numbers of bytes. An invalid value is an error, never ignored.
#pragma once

#include <cstdint>
#include <string_view>

namespace glift::detail {

/// True if the variable is 1, false if it is 0, empty or not set; throws wrong_argument for any other value.
bool environment_flag(const char* name);

/// Whether Vulkan devices run the general form of every kernel (GLIFT_GENERAL_FORM=1), as tests do.
bool forces_general_form();

/// Parses a number of bytes: digits, then nothing or K, M, G or T for powers of 1024 (`2G`, also `2GiB`, `2GB`).
/// Throws wrong_argument, naming the variable, for other texts.
std::uint64_t bytes_of_text(const char* name, std::string_view text);

/// The bytes that GLIFT_MEMORY_LIMIT says; the constant `unlimited` of glift/device.h if it is not set or empty.
std::uint64_t memory_limit();

}  // namespace glift::detail
