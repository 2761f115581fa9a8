// The text of a message: its format with the scalars in place.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace glift::detail {

/// How many words the placeholders of a MessageFormat::text take.
std::uint32_t words_of_format(std::string_view format);

/// The format with the values of the words, of which there are words_of_format(). Floating-point numbers have as few
/// digits as their type needs to read them back.
std::string filled_format(std::string_view format, std::span<const std::uint32_t> words);

}  // namespace glift::detail
