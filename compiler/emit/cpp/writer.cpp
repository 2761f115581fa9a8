#include "emit/cpp/writer.h"

#include "base/concat.h"

#include <algorithm>
#include <vector>

namespace gliftc::cpp {

namespace {

/// A place where a line may be broken, with the depth of brackets there: after a comma, or before one of
/// `&&`, `||`, `?`, `:`, `+`.
struct Break {
    std::size_t at;
    int depth;
};

std::vector<Break> breaks_of(std::string_view text) {
    std::vector<Break> breaks;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"' || c == '\'') {
            for (std::size_t end = i + 1; end < text.size(); ++end) {
                if (text[end] == '\\') ++end;
                else if (text[end] == c) {
                    i = end;
                    break;
                }
            }
        } else if (c == '(' || c == '[' || c == '{') {
            ++depth;
        } else if (c == ')' || c == ']' || c == '}') {
            --depth;
        } else if (c == ',' && i + 1 < text.size() && text[i + 1] == ' ') {
            breaks.push_back({i + 2, depth});
        } else if (c == ' ' && i + 3 < text.size()) {
            const std::string_view next = text.substr(i + 1, 3);
            if (next == "&& " || next == "|| " || next.starts_with("? ") || next.starts_with(": ") ||
                next.starts_with("+ "))
                breaks.push_back({i + 1, depth});
        }
    }
    return breaks;
}

}  // namespace

void Writer::line(std::string_view text) {
    std::size_t indent = static_cast<std::size_t>(depth_) * 4;
    std::string_view comment = text.starts_with("//") ? text : std::string_view();
    while (comment.empty() && indent + text.size() > line_width) {
        const std::size_t room = line_width - indent;
        std::size_t best = 0;
        int best_depth = 1 << 30;
        for (const Break& candidate : breaks_of(text)) {
            if (candidate.at > room + 1) break;
            if (candidate.at < room / 3) continue;
            if (candidate.depth <= best_depth) best = candidate.at, best_depth = candidate.depth;
        }
        if (best == 0) break;
        std::string_view head = text.substr(0, best);
        while (head.ends_with(' ')) head.remove_suffix(1);
        out_.append(indent, ' ');
        out_ += head;
        out_ += '\n';
        text.remove_prefix(best);
        indent = static_cast<std::size_t>(depth_ + 1) * 4;
    }
    if (!text.empty()) out_.append(indent, ' ');
    out_ += text;
    out_ += '\n';
}

void Writer::gap() {
    if (out_.empty() || out_.ends_with("\n\n") || out_.ends_with("{\n") || out_.ends_with(":\n")) return;
    out_ += '\n';
}

void Writer::parts(const std::vector<std::string_view>& parts) {
    std::size_t bytes = 0;
    for (std::string_view part : parts) bytes += part.size() + 1;
    reserve(bytes);
    for (std::string_view part : parts) {
        raw(part);
        gap();
    }
}

void Writer::open(std::string_view text) {
    line(text.empty() ? "{" : concat(text, " {"));
    ++depth_;
}

void Writer::close(std::string_view after) {
    --depth_;
    while (out_.ends_with("\n\n")) out_.pop_back();
    line(concat("}", after));
}

std::string quoted(std::string_view text) {
    static constexpr char digits[] = "01234567";
    std::string result = "\"";
    for (std::size_t i = 0; i < text.size(); ++i) {
        const unsigned char c = static_cast<unsigned char>(text[i]);
        const bool repeats = c == '?' && i > 0 && text[i - 1] == '?';  // ??/ is a backslash where trigraphs are read
        if (c == '\n') result += "\\n";
        else if (c < 32 || c == 127) result += {'\\', digits[c >> 6], digits[c >> 3 & 7], digits[c & 7]};
        else if (c == '"' || c == '\\' || repeats) result += {'\\', static_cast<char>(c)};
        else result += static_cast<char>(c);
    }
    return result + '"';
}

std::string in_line(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if ((c >= 0 && c < 32) || c == 127 || c == '"' || c == '\\') c = '?';
    return result;
}

namespace {

bool is_item(std::string_view line) {
    return line.starts_with("- ") || line.starts_with("* ") || line.starts_with("+ ");
}

/// Whether a line of a documentation comment does not continue the paragraph before it: it is blank, indented, an item
/// of a list, or begins with a mark of Markdown or Doxygen.
bool stands_alone(std::string_view line) {
    const auto begins = [&](const char* mark) { return line.starts_with(mark); };
    const std::size_t digits = line.find_first_not_of("0123456789");
    const bool is_numbered = digits > 0 && digits != std::string_view::npos && line.substr(digits).starts_with(". ");
    return line.empty() || is_item(line) || is_numbered ||
           std::ranges::any_of(std::initializer_list<const char*>{" ", "|", "#", ">", "```", "@", "\\"}, begins);
}

/// Writes a paragraph as lines that fit; those after the first begin with `hang`.
void write_wrapped(Writer& writer, std::string_view text, std::string_view hang) {
    constexpr std::size_t room = 112;
    std::string_view lead;
    const auto put = [&](std::string_view line) {
        // A backslash at the end would take the next line into the comment.
        const bool goes_on = line.ends_with('\\') || line.ends_with("?\?/");
        writer.line(line.empty() ? "///" : concat("/// ", lead, line, goes_on ? " ." : ""));
    };
    while (lead.size() + text.size() > room) {
        const std::size_t start = text.find_first_not_of(' '), space = text.rfind(' ', room - lead.size());
        if (space == std::string_view::npos || space <= start) break;
        put(text.substr(0, space));
        text.remove_prefix(space + 1);
        lead = hang;
    }
    put(text);
}

}  // namespace

void write_doc(Writer& writer, std::string_view doc) {
    std::string paragraph;
    bool is_open = false, is_code = false;  // the next line may continue the paragraph; is between ``` and ```
    bool has_any = false;
    const auto finish = [&] {
        if (has_any) write_wrapped(writer, paragraph, is_item(paragraph) ? "  " : "");
    };
    while (!doc.empty()) {
        const std::size_t end = doc.find('\n');
        std::string_view line = doc.substr(0, end);
        doc = end == std::string_view::npos ? std::string_view() : doc.substr(end + 1);
        while (line.ends_with(' ')) line.remove_suffix(1);
        const bool is_fence = line.starts_with("```");
        std::string_view rest = line;
        if (is_item(paragraph) && rest.starts_with("  ")) rest.remove_prefix(2);
        if (is_open && !is_code && !stands_alone(rest)) {
            paragraph += concat(" ", rest);
            continue;
        }
        finish();
        has_any = true;
        paragraph = line;
        is_code = is_code != is_fence;
        is_open = !is_code && (!stands_alone(line) || is_item(line));
    }
    finish();
}

}  // namespace gliftc::cpp
