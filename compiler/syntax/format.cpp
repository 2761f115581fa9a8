#include "syntax/format.h"

#include "syntax/format_pieces.h"
#include "syntax/lexer.h"
#include "syntax/parser.h"

#include <algorithm>

namespace gliftc {

namespace {

constexpr std::size_t widest = 120, level = 4, widest_alignment = 60;

/// Breaks pieces into lines. A statement ends with `;` or with a block; it stays on one line if each of its blocks was
/// on one line in the source, no comment is inside and it fits.
class Formatter {
public:
    explicit Formatter(const std::vector<Piece>& pieces) : pieces_(pieces) {}

    std::string run() {
        statements(static_cast<std::uint32_t>(pieces_.size() - 1), 0);
        if (!out_.empty()) out_ += '\n';
        align_trailing_comments();
        return std::move(out_);
    }

private:
    // ---- ends of constructs

    /// The index of the piece after the statement that begins at `from`. Comments that trail the statement are not part
    /// of it.
    std::uint32_t end_of_statement(std::uint32_t from, std::uint32_t limit) const {
        for (std::uint32_t i = from; i < limit; ++i) {
            const Piece& piece = pieces_[i];
            if (piece.is(TokenKind::semicolon)) return i + 1;
            if (!piece.opens()) continue;
            i = piece.partner;
            if (!piece.opens_block()) continue;
            std::uint32_t next = i + 1;
            while (next < limit && pieces_[next].is_comment()) ++next;
            const bool is_case = next + 1 < limit && pieces_[next + 1].is(TokenKind::colon);
            if (next >= limit || !pieces_[next].is(TokenKind::kw_else) || is_case) return i + 1;
        }
        return limit;
    }

    /// The index of the piece after the attributes `@name(arguments) @name…` that begin at `from` and stand on one
    /// line, if that piece begins a new line and is no comment; else `from`.
    std::uint32_t end_of_attribute(std::uint32_t from, std::uint32_t limit) const {
        std::uint32_t end = from;
        while (end < limit && pieces_[end].is(TokenKind::at_sign) && (end == from || !pieces_[end].first_on_line)) {
            end += 2;
            if (end < limit && pieces_[end].is(TokenKind::open_paren)) end = pieces_[end].partner + 1;
        }
        return end > from && end < limit && pieces_[end].first_on_line && !pieces_[end].is_comment() ? end : from;
    }

    // ---- one line

    /// Whether nothing in [from, to) forces a line break.
    bool is_flat(std::uint32_t from, std::uint32_t to) const {
        for (std::uint32_t i = from; i < to; ++i) {
            const Piece& piece = pieces_[i];
            if (piece.is_comment()) return false;
            if (!piece.opens_block()) continue;
            for (std::uint32_t k = i + 1; k <= piece.partner; ++k)
                if (pieces_[k].first_on_line) return false;
        }
        return true;
    }

    std::string flat(std::uint32_t from, std::uint32_t to) const {
        std::string text;
        bool is_path = pieces_[from].is(TokenKind::kw_use);
        for (std::uint32_t i = from; i < to; ++i) {
            bool in_path = is_path && i > from + 1;
            if (i > from && !in_path && space_between(pieces_[i - 1], pieces_[i])) text += ' ';
            text += pieces_[i].text;
        }
        return text;
    }

    // ---- lines

    void new_line(std::size_t indent) {
        if (!out_.empty()) out_ += '\n';
        line_start_ = out_.size();
        out_.append(indent, ' ');
    }
    std::size_t column() const { return out_.size() - line_start_; }

    void blank_line_before(std::uint32_t i, bool first) {
        if (pieces_[i].blank_before && !first) out_ += '\n';
    }

    /// Formats the statements and comments from the current piece to `limit`.
    void statements(std::uint32_t limit, std::size_t indent) {
        bool first = true;
        while (at_ < limit) {
            blank_line_before(at_, first);
            first = false;
            if (pieces_[at_].is_comment() && stands_alone(at_, limit)) {
                new_line(indent);
                out_ += pieces_[at_++].text;
                continue;
            }
            new_line(indent);
            std::uint32_t end = end_of_attribute(at_, limit);
            if (end == at_) end = end_of_statement(at_, limit);
            statement(end, indent);
            trailing_comments(limit);
        }
    }

    bool stands_alone(std::uint32_t i, std::uint32_t limit) const {
        return pieces_[i].kind == PieceKind::line_comment || i + 1 >= limit || pieces_[i + 1].first_on_line;
    }

    /// Appends comments that follow code on the same line.
    void trailing_comments(std::uint32_t limit) {
        while (at_ < limit && pieces_[at_].is_comment() && !pieces_[at_].first_on_line) {
            trailing_.push_back({line_start_, out_.size()});
            out_ += "  ";
            out_ += pieces_[at_++].text;
        }
    }

    /// Aligns the trailing comments of consecutive lines that have the same indentation.
    void align_trailing_comments() {
        auto indent = [&](const Trailing& t) { return out_.find_first_not_of(' ', t.line) - t.line; };
        auto follows = [&](const Trailing& a, const Trailing& b) {
            return out_.find('\n', a.code_end) + 1 == b.line && indent(a) == indent(b);
        };
        std::string aligned;
        std::size_t copied = 0;
        for (std::size_t first = 0, end = 0; first < trailing_.size(); first = end) {
            std::size_t column = 0;
            for (end = first; end < trailing_.size() && (end == first || follows(trailing_[end - 1], trailing_[end]));
                 ++end)
                column = std::max(column, trailing_[end].code_end - trailing_[end].line);
            for (std::size_t i = first; i < end; ++i) {
                aligned.append(out_, copied, trailing_[i].code_end - copied);
                aligned.append(column - (trailing_[i].code_end - trailing_[i].line), ' ');
                copied = trailing_[i].code_end;
            }
        }
        out_ = aligned.append(out_, copied);
    }

    void statement(std::uint32_t end, std::size_t indent) {
        if (is_flat(at_, end)) {
            std::string text = flat(at_, end);
            if (column() + text.size() <= widest) {
                out_ += text;
                at_ = end;
                return;
            }
        }
        bool is_enum = false;
        while (at_ < end) {
            std::uint32_t stop = at_;
            while (stop < end && !pieces_[stop].opens_block()) {
                is_enum |= pieces_[stop].is(TokenKind::kw_enum);
                stop = pieces_[stop].opens() ? pieces_[stop].partner + 1 : stop + 1;
            }
            stop = std::min(stop, end);
            wrap(stop, indent, stop < end ? 2 : 0);
            if (stop < end) block(indent, is_enum);
        }
    }

    /// `{`, the contents indented by one level, `}`.
    void block(std::size_t indent, bool is_enum) {
        std::uint32_t close = pieces_[at_].partner;
        const bool is_after_comment = at_ > 0 && pieces_[at_ - 1].kind == PieceKind::line_comment;
        if (is_after_comment) new_line(indent);
        else if (column() > indent) out_ += ' ';
        out_ += '{';
        ++at_;
        if (at_ == close) {
            out_ += " }";
            ++at_;
            return;
        }
        trailing_comments(close);
        if (is_enum) {
            enumerators(close, indent + level);
        } else {
            statements(close, indent + level);
        }
        new_line(indent);
        out_ += '}';
        ++at_;
    }

    /// Formats enumerators, one per line.
    void enumerators(std::uint32_t close, std::size_t indent) {
        while (at_ < close) {
            new_line(indent);
            if (pieces_[at_].is_comment()) {
                out_ += pieces_[at_++].text;
                continue;
            }
            std::uint32_t end = at_;
            while (end < close && !pieces_[end].is(TokenKind::comma) && !pieces_[end].is_comment())
                end = pieces_[end].opens() ? pieces_[end].partner + 1 : end + 1;
            if (end < close && pieces_[end].is(TokenKind::comma)) ++end;
            wrap(end, indent, 0);
            trailing_comments(close);
        }
    }

    /// Formats the pieces up to `end`, with line breaks where needed; `room` columns stay free after the last piece.
    void wrap(std::uint32_t end, std::size_t indent, std::size_t room) {
        std::uint32_t first = at_;
        std::vector<std::size_t> alignment;
        while (at_ < end) {
            const Piece& piece = pieces_[at_];
            if (piece.opens_block()) {  // of a closure
                block(indent, false);
                continue;
            }
            bool forced = at_ > first && (pieces_[at_ - 1].kind == PieceKind::line_comment ||
                                          (piece.is_comment() && piece.first_on_line));
            bool over = at_ > first && breaks_before(at_, end, room);
            if (forced || over) {
                std::size_t aligned = alignment.empty() ? indent + 2 * level : alignment.back();
                new_line(aligned > widest_alignment ? indent + 2 * level : aligned);
            } else if (at_ > first ? space_between(pieces_[at_ - 1], piece) : column() > indent) {
                out_ += piece.is_comment() && !piece.first_on_line ? "  " : " ";
            }
            out_ += piece.text;
            if (piece.opens()) alignment.push_back(column());
            if (piece.closes() && !alignment.empty()) alignment.pop_back();
            ++at_;
        }
    }

    /// Whether a line break is needed before piece `i`: the text up to the next possible break, at this nesting depth
    /// or an outer one, does not fit.
    bool breaks_before(std::uint32_t i, std::uint32_t end, std::size_t room) const {
        if (!may_break_between(pieces_[i - 1], pieces_[i])) return false;
        std::size_t length = column() + (space_between(pieces_[i - 1], pieces_[i]) ? 1 : 0);
        int depth = 0;
        for (std::uint32_t k = i; k < end; ++k) {
            if (k > i) {
                if (pieces_[k - 1].kind == PieceKind::line_comment || pieces_[k].is_comment()) return length > widest;
                if (depth <= 0 && may_break_between(pieces_[k - 1], pieces_[k])) return length > widest;
                if (pieces_[k].opens_block()) return length + 2 > widest;
                length += space_between(pieces_[k - 1], pieces_[k]) ? 1 : 0;
            }
            length += pieces_[k].text.size();
            if (pieces_[k].opens()) ++depth;
            if (pieces_[k].closes()) --depth;
        }
        return length + room > widest;
    }

    const std::vector<Piece>& pieces_;
    std::uint32_t at_ = 0;
    std::string out_;
    std::size_t line_start_ = 0;

    struct Trailing {
        std::size_t line, code_end;  // offsets in the output: of the line, and of the end of its code
    };
    std::vector<Trailing> trailing_;
};

}  // namespace

std::optional<std::string> format(std::uint32_t file, const Sources& sources, Names& names, Diagnostics& diagnostics) {
    if (diagnostics.at_limit()) return std::nullopt;  // nothing is parsed then, and no further error is counted
    std::size_t errors = diagnostics.error_count();
    TokenList written = lex(file, sources, names, diagnostics);
    TokenList read = written;
    ast::Tree tree;
    parse(read, file, sources, names, tree, diagnostics);
    if (diagnostics.error_count() > errors) return std::nullopt;
    return Formatter(make_pieces(sources[file].text, written, read)).run();
}

}  // namespace gliftc
