// Lines of text.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

namespace gliftc {

/// The text without the lines that begin with one of these, after spaces.
inline std::string without_lines(std::string_view text, std::initializer_list<std::string_view> beginnings) {
    std::string rest;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        const std::string_view line = text.substr(begin, end - begin);
        const std::string_view words = line.substr(std::min(line.find_first_not_of(' '), line.size()));
        if (std::ranges::none_of(beginnings, [&](std::string_view with) { return words.starts_with(with); }))
            rest += line;
        begin = end;
    }
    return rest;
}

}  // namespace gliftc
