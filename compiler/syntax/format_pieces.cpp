#include "syntax/format_pieces.h"

#include "syntax/token_set.h"

#include <algorithm>

namespace gliftc {

namespace {

using enum TokenKind;
/// The operators before which a line may break, besides `?` and `:` with Role::spaced.
constexpr TokenSet loose_operators{question_question, bar_bar, ampersand_ampersand, plus, minus, kw_then};
constexpr TokenSet tight_before{close_paren, close_bracket, comma, semicolon, dot};
constexpr TokenSet tight_after{open_paren, open_bracket, dot, at_sign};
constexpr TokenSet ends_value{identifier, close_paren, close_bracket};

class PieceMaker {
public:
    PieceMaker(std::string_view text, const TokenList& written, const TokenList& read)
        : text_(text), written_(written), read_(read) {}

    std::vector<Piece> run() {
        std::size_t comment = 0;
        for (std::uint32_t i = 0; i < written_.tokens.size(); ++i) {
            for (; comment < written_.comments.size() && written_.comments[comment].next_token <= i; ++comment)
                add_comment(written_.comments[comment]);
            if (written_.tokens[i].kind != end) add_token(i);
        }
        pieces_.emplace_back();
        match_brackets();
        return std::move(pieces_);
    }

private:
    Piece& add(PieceKind kind, std::uint32_t begin, std::uint32_t end) {
        Piece piece;
        piece.kind = kind;
        piece.text = text_.substr(begin, end - begin);
        std::string_view gap = text_.substr(end_, begin - end_);
        auto newlines = std::count(gap.begin(), gap.end(), '\n');
        piece.blank_before = newlines >= 2;
        piece.first_on_line = newlines >= 1 || pieces_.empty();
        piece.space_before = !gap.empty();
        end_ = end;
        pieces_.push_back(piece);
        return pieces_.back();
    }

    void add_comment(const Comment& comment) {
        std::uint32_t end = comment.end;
        while (end > comment.begin && (text_[end - 1] == ' ' || text_[end - 1] == '\t')) --end;
        bool is_line = text_.substr(comment.begin, 2) == "//";
        add(is_line ? PieceKind::line_comment : PieceKind::block_comment, comment.begin, end);
    }

    /// A token such as `>>`, `>=` or `??` that the parser split becomes several pieces.
    void add_token(std::uint32_t i) {
        const Token& token = written_.tokens[i];
        const Token& parsed = read_.tokens[i];
        for (std::uint32_t at = token.begin; at < parsed.begin; ++at) {
            Piece& part = add(PieceKind::token, at, at + 1);
            const bool is_optional = text_[at] == '?';
            part.token = is_optional ? question : greater;
            part.role = is_optional ? Role::optional : Role::close_generic;
        }
        Piece& piece = add(PieceKind::token, parsed.begin, parsed.end);
        piece.token = parsed.kind;
        piece.role = parsed.role;
    }

    void match_brackets() {
        std::vector<std::uint32_t> open;
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            if (pieces_[i].opens()) open.push_back(i);
            if (!pieces_[i].closes() || open.empty()) continue;
            pieces_[open.back()].partner = i;
            open.pop_back();
        }
    }

    std::string_view text_;
    const TokenList& written_;
    const TokenList& read_;
    std::uint32_t end_ = 0;
    std::vector<Piece> pieces_;
};

}  // namespace

std::vector<Piece> make_pieces(std::string_view text, const TokenList& written, const TokenList& read) {
    return PieceMaker(text, written, read).run();
}

bool space_between(const Piece& before, const Piece& after) {
    if (before.is_comment() || after.is_comment() || before.is(kw_use)) return true;
    if (tight_before.has(after.token) || after.role == Role::close_generic || after.role == Role::optional)
        return false;
    if (after.role == Role::close_tuple || before.role == Role::open_tuple) return false;
    if (tight_after.has(before.token) || before.role == Role::open_generic || after.role == Role::open_generic)
        return false;
    if (before.role == Role::unary) return before.token == kw_await;
    if (before.token == dot_dot || after.token == dot_dot) return after.space_before;
    if (after.token == colon) return after.role == Role::spaced;
    bool behind_value =
        ends_value.has(before.token) || before.role == Role::close_generic || before.role == Role::optional;
    if (after.token == open_paren || after.token == open_bracket) return !behind_value;
    return true;
}

bool may_break_between(const Piece& before, const Piece& after) {
    if (before.is(comma)) return true;
    if (after.is_comment() || before.is_comment() || after.role == Role::unary) return false;
    if (after.role == Role::open_generic || after.role == Role::close_generic) return false;
    bool is_operator = after.kind == PieceKind::token &&
                       (loose_operators.has(after.token) || (after.is(question) && after.role == Role::spaced));
    return is_operator || (after.is(colon) && after.role == Role::spaced);
}

}  // namespace gliftc
