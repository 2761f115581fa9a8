// The formatter's input: tokens, with the roles that the parser gave them, and comments.
#pragma once

#include "syntax/token.h"

#include <string_view>
#include <vector>

namespace gliftc {

enum class PieceKind : std::uint8_t { token, line_comment, block_comment, end };

struct Piece {
    PieceKind kind = PieceKind::end;
    TokenKind token = TokenKind::end;
    Role role = Role::none;
    std::string_view text;
    bool first_on_line = false;  ///< in the source
    bool blank_before = false;   ///< an empty line precedes it in the source
    bool space_before = false;   ///< white space precedes it in the source
    std::uint32_t partner = 0;   ///< of an opening bracket: the index of the piece that closes it

    bool is(TokenKind wanted) const { return kind == PieceKind::token && token == wanted; }
    bool is_comment() const { return kind == PieceKind::line_comment || kind == PieceKind::block_comment; }
    bool opens_block() const { return is(TokenKind::open_brace) && role != Role::open_tuple; }
    /// Whether it is one of the bars around the parameters of a closure.
    bool is_bar(Role side) const { return is(TokenKind::bar) && role == side; }
    bool opens() const {
        return is(TokenKind::open_paren) || is(TokenKind::open_bracket) || is(TokenKind::open_brace) ||
               role == Role::open_generic || is_bar(Role::open_tuple);
    }
    bool closes() const {
        return is(TokenKind::close_paren) || is(TokenKind::close_bracket) || is(TokenKind::close_brace) ||
               role == Role::close_generic || is_bar(Role::close_tuple);
    }
};

/// The pieces of a file that parsed without errors; the last is `end`. `written` are the tokens as the lexer made them.
/// `read` are the same tokens as the parser left them: it sets roles, and shortens a token like `>>` that it consumes
/// in parts to the last part.
std::vector<Piece> make_pieces(std::string_view text, const TokenList& written, const TokenList& read);

/// Whether there is a space between two neighbouring pieces on one line.
bool space_between(const Piece& before, const Piece& after);

/// Whether a line that is too long may break between these two neighbouring pieces.
bool may_break_between(const Piece& before, const Piece& after);

}  // namespace gliftc
