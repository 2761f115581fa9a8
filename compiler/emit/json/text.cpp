#include "emit/json/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace gliftc::json {

void Text::key(std::string_view name) {
    begin_entry();
    quote(name);
    text_ += ": ";
    follows_key_ = true;
}

void Text::value(std::string_view string) {
    begin_value();
    quote(string);
}

void Text::literal(std::string_view text) {
    begin_value();
    text_ += text;
}

void Text::begin_value() {
    if (!follows_key_ && depth_ > 0) begin_entry();
    follows_key_ = false;
}

void Text::begin_entry() {
    if (!is_empty_) text_ += ',';
    is_empty_ = false;
    break_line();
}

void Text::break_line() {
    text_ += '\n';
    text_.append(2 * depth_, ' ');
}

void Text::quote(std::string_view string) {
    const bool is_plain =
        std::ranges::all_of(string, [](char c) { return c >= ' ' && c < '\x7f' && c != '"' && c != '\\'; });
    if (is_plain) {
        text_ += '"';
        text_ += string;
        text_ += '"';
        return;
    }
    // The library handles what is rare: characters to be escaped, and bytes beyond ASCII, of which it replaces those
    // that are not UTF-8.
    text_ += nlohmann::json(string).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace gliftc::json
