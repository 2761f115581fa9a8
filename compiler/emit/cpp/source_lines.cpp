#include "emit/cpp/source_lines.h"

#include "emit/cpp/writer.h"

#include <algorithm>

namespace gliftc::cpp {

namespace {

std::size_t indent_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// What a comment says of the lines that follow it in its block.
struct Mark {
    std::string directive;  ///< `#line 7 "…/name.glift"`; empty: the lines are the generated file's own
    std::size_t indent = 0;
};

/// `// name.glift:7` and nothing else, as mark_line writes it.
bool is_mark(std::string_view comment, std::string_view& file, std::string_view& line) {
    constexpr std::string_view begin = "// ", ending = ".glift:";
    const std::size_t at = comment.find(ending);
    if (!comment.starts_with(begin) || at == std::string_view::npos) return false;
    file = comment.substr(begin.size(), at + ending.size() - 1 - begin.size());
    line = comment.substr(at + ending.size());
    return !line.empty() && std::ranges::all_of(line, [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::string with_source_lines(std::string_view text, const std::string& name,
                              const std::function<std::string(std::string_view)>& path_of) {
    std::string result;
    std::size_t written = 0;  // lines
    const auto put = [&](std::string_view line) {
        result.append(line).append("\n");
        ++written;
    };
    Mark mark;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        const std::size_t indent = indent_of(line);
        std::string_view file, number;
        if (!mark.directive.empty() && indent < mark.indent && indent < line.size()) {
            mark = {};
            put("#line " + std::to_string(written + 2) + " " + quoted(name));
        }
        if (is_mark(line.substr(indent), file, number))
            mark = {"#line " + std::string(number) + " " + quoted(path_of(file)), indent};
        else if (!mark.directive.empty() && indent < line.size()) put(mark.directive);
        put(line);
    }
    return result;
}

}  // namespace gliftc::cpp
