// Text made line by line, indented by four spaces for each level of nesting.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gliftc::cpp {

inline constexpr std::size_t line_width = 120;

class Writer {
public:
    /// One line at the present depth. A line longer than line_width is broken after a comma or before `&&`, `||`, `?`,
    /// `:` or `+`: of those places that fit and are not in the first third of the room, at the last one of the lowest
    /// depth of brackets. Lines without such a place, and comments, are not broken.
    void line(std::string_view text);
    /// Adds an empty line, unless there is one already, no line has been written, a block has just begun, or the last
    /// line is a label (`public:`).
    void gap();
    /// `text {` and one level deeper.
    void open(std::string_view text);
    /// One level less deep and `}` followed by `after`.
    void close(std::string_view after = "");
    void indent() { ++depth_; }
    void dedent() { --depth_; }
    int depth() const { return depth_; }
    /// Adds text as it is: preprocessor lines, finished pieces.
    void raw(std::string_view text) { out_ += text; }
    /// Finished pieces, with an empty line after each.
    void parts(const std::vector<std::string_view>& parts);
    /// Makes room for so many more bytes.
    void reserve(std::size_t bytes) { out_.reserve(out_.size() + bytes); }

    const std::string& text() const { return out_; }
    std::string take() { return std::move(out_); }

private:
    std::string out_;
    int depth_ = 0;
};

/// The text as a string literal of C++: "say \"hi\"\n".
std::string quoted(std::string_view text);

/// The text as it may stand within a line, also in a literal or a comment: with '?' in place of control characters, '"'
/// and '\'.
std::string in_line(std::string_view text);

/// `/// ` lines for a documentation comment; nothing for an empty one. The lines of a paragraph, or of an item of a
/// bulleted list, are joined and broken anew. Blank, indented and numbered lines, lines between ``` and lines that
/// begin with another mark of Markdown or Doxygen are not joined.
void write_doc(Writer& writer, std::string_view doc);

}  // namespace gliftc::cpp
