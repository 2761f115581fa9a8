#include "source/source.h"

#include <algorithm>
#include <cstring>

namespace gliftc {

namespace {

std::vector<std::uint32_t> find_line_starts(std::string_view text) {
    std::vector<std::uint32_t> starts{0};
    for (std::size_t at = 0; at < text.size();) {
        const void* found = std::memchr(text.data() + at, '\n', text.size() - at);
        if (!found) break;
        at = static_cast<std::size_t>(static_cast<const char*>(found) - text.data()) + 1;
        starts.push_back(static_cast<std::uint32_t>(at));
    }
    return starts;
}

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

}  // namespace

std::uint32_t Sources::add(std::string path, std::string text) {
    auto starts = find_line_starts(text);
    files_.push_back({std::move(path), std::move(text), std::move(starts)});
    return size() - 1;
}

std::string_view Sources::text(Span span) const {
    if (!span) return {};
    return std::string_view(files_[span.file].text).substr(span.begin, span.end - span.begin);
}

std::uint32_t Sources::line_of(Span span) const {
    if (!span) return 1;
    const std::vector<std::uint32_t>& starts = files_[span.file].line_starts;
    return static_cast<std::uint32_t>(std::upper_bound(starts.begin(), starts.end(), span.begin) - starts.begin());
}

Position Sources::position(Span span) const {
    if (!span) return {};
    const SourceFile& file = files_[span.file];
    const std::uint32_t line = line_of(span);
    std::uint32_t start = file.line_starts[line - 1];
    std::uint32_t column = 1;
    for (std::uint32_t i = start; i < span.begin && i < file.text.size(); ++i)
        if (!is_continuation_byte(file.text[i])) ++column;
    return {line, column};
}

std::string_view Sources::line(std::uint32_t file, std::uint32_t line) const {
    const SourceFile& source = files_[file];
    if (line == 0 || line > source.line_starts.size()) return {};
    std::string_view text = source.text;
    std::size_t begin = source.line_starts[line - 1];
    std::size_t end = line < source.line_starts.size() ? source.line_starts[line] - 1 : text.size();
    if (end > begin && text[end - 1] == '\r') --end;
    return text.substr(begin, end - begin);
}

}  // namespace gliftc
