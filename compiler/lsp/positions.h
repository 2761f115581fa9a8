// Positions of the protocol: a line from 0 and a character from 0, counted in UTF-16 code units. The compiler's are
// byte offsets in UTF-8.
#pragma once

#include "source/source.h"

#include <nlohmann/json_fwd.hpp>

namespace gliftc::lsp {

struct TextPosition {
    std::uint32_t line = 0;
    std::uint32_t character = 0;
    auto operator<=>(const TextPosition&) const = default;
};

/// Bytes that are no valid UTF-8 count as one unit each.
TextPosition position_of(std::string_view text, std::size_t offset);
/// The same, with the file's table of lines.
TextPosition position_of(const SourceFile& file, std::size_t offset);
/// Positions beyond the end of a line mean its end, before the line break; lines beyond the last one the end of the
/// text; those inside of a character its beginning.
std::size_t offset_of(std::string_view text, TextPosition position);

/// Throws InvalidParams (lsp/protocol.h) if the value is no position: an object with two numbers that are not negative.
TextPosition read_position(const nlohmann::json& value);
nlohmann::json to_json(TextPosition position);

/// The range of the bytes [begin, end).
nlohmann::json range_of(std::string_view text, std::size_t begin, std::size_t end);
nlohmann::json range_of(const Sources& sources, Span span);

}  // namespace gliftc::lsp
