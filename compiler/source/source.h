// Source files and locations in them.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace gliftc {

/// Bytes [begin, end) of file `file` of a Sources. Offsets are bytes, not characters.
struct Span {
    std::uint32_t file = 0xffffffffu;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    explicit operator bool() const { return file != 0xffffffffu; }
    bool operator==(const Span&) const = default;
};

/// The smallest span that contains both, which must be of one file. If one of them has no file, the other.
inline Span join(Span a, Span b) {
    if (!a) return b;
    if (!b) return a;
    return {a.file, a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

/// A line and a column, both from 1; columns count characters (code points).
struct Position {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
};

/// One file's text with its line starts.
struct SourceFile {
    std::string path;  ///< as given on the command line or found for an import; normalised, with '/' as separator,
                       ///< except in `gliftc fmt`. "<stdin>": standard input
    std::string text;
    std::vector<std::uint32_t> line_starts;  ///< byte offset of each line's first byte
};

/// All files of one compilation.
class Sources {
public:
    std::uint32_t add(std::string path, std::string text);
    const SourceFile& operator[](std::uint32_t file) const { return files_[file]; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(files_.size()); }

    std::string_view text(Span span) const;
    Position position(Span span) const;                                   ///< position of the span's first byte
    std::uint32_t line_of(Span span) const;                               ///< line of the span's first byte
    std::string_view line(std::uint32_t file, std::uint32_t line) const;  ///< without its end of line

private:
    std::deque<SourceFile> files_;
};

}  // namespace gliftc
