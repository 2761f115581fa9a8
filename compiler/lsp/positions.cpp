#include "lsp/positions.h"

#include "lsp/protocol.h"

#include <algorithm>
#include <limits>

namespace gliftc::lsp {

namespace {

/// A character at the beginning of a text: its bytes, and its UTF-16 code units.
struct Character {
    std::size_t bytes = 1;
    std::uint32_t units = 1;
};

Character character_at(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t length = first >= 0xf0 && first < 0xf8 ? 4 : first >= 0xe0 ? 3 : first >= 0xc0 ? 2 : 1;
    if (length > text.size() || first >= 0xf8) return {};
    for (std::size_t i = 1; i < length; ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return {};
    return {length, length == 4 ? 2u : 1u};
}

std::uint32_t units_of(std::string_view text) {
    std::uint32_t units = 0;
    for (std::size_t at = 0; at < text.size();) {
        const Character character = character_at(text.substr(at));
        at += character.bytes;
        units += character.units;
    }
    return units;
}

std::size_t line_start(std::string_view text, std::uint32_t line) {
    std::size_t at = 0;
    for (std::uint32_t i = 0; i < line; ++i) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string_view::npos) return text.size();
        at = end + 1;
    }
    return at;
}

std::uint32_t number_member(const nlohmann::json& value, const char* key) {
    const nlohmann::json& number = member(value, key);
    const bool is_whole =
        number.is_number_unsigned() || (number.is_number_integer() && number.get<std::int64_t>() >= 0);
    if (!is_whole) throw InvalidParams(std::string("'") + key + "' is no number from 0 on");
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::min(number.get<std::uint64_t>(), most));
}

}  // namespace

TextPosition position_of(std::string_view text, std::size_t offset) {
    offset = std::min(offset, text.size());
    const std::string_view before = text.substr(0, offset);
    const auto line = static_cast<std::uint32_t>(std::ranges::count(before, '\n'));
    const std::size_t line_end = before.rfind('\n');
    return {line, units_of(before.substr(line_end == std::string_view::npos ? 0 : line_end + 1))};
}

TextPosition position_of(const SourceFile& file, std::size_t offset) {
    offset = std::min(offset, file.text.size());
    const auto after = std::ranges::upper_bound(file.line_starts, offset);
    if (after == file.line_starts.begin()) return {};
    const std::size_t start = *(after - 1);
    return {static_cast<std::uint32_t>(after - 1 - file.line_starts.begin()),
            units_of(std::string_view(file.text).substr(start, offset - start))};
}

std::size_t offset_of(std::string_view text, TextPosition position) {
    std::size_t at = line_start(text, position.line);
    std::size_t end = std::min(text.find('\n', at), text.size());
    if (end > at && text[end - 1] == '\r') --end;
    for (std::uint32_t units = 0; at < end;) {
        const Character character = character_at(text.substr(at, end - at));
        units += character.units;
        if (units > position.character) break;
        at += character.bytes;
    }
    return at;
}

TextPosition read_position(const nlohmann::json& value) {
    return {number_member(value, "line"), number_member(value, "character")};
}

nlohmann::json to_json(TextPosition position) { return {{"line", position.line}, {"character", position.character}}; }

nlohmann::json range_of(std::string_view text, std::size_t begin, std::size_t end) {
    return {{"start", to_json(position_of(text, begin))}, {"end", to_json(position_of(text, end))}};
}

nlohmann::json range_of(const Sources& sources, Span span) {
    const SourceFile& file = sources[span.file];
    return {{"start", to_json(position_of(file, span.begin))}, {"end", to_json(position_of(file, span.end))}};
}

}  // namespace gliftc::lsp
