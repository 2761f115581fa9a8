// Tokens and comments, the lexer's output.
#pragma once

#include "base/name.h"
#include "source/source.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace gliftc {

enum class TokenKind : std::uint8_t {
    end,  // the end of the file: always the last token
    identifier,
    integer,
    floating,
    bad_number,  // malformed; the parser reports it
    string,
    bad_character,  // one or several characters that begin no token; reported already
#define PUNCTUATION(name, text) name,
#define KEYWORD(text) kw_##text,
#define WORD(text)
#include "syntax/tokens.def"
#undef PUNCTUATION
#undef KEYWORD
#undef WORD
};

/// Contextual keywords; `no_word` for other identifiers.
enum class Word : std::uint8_t {
    no_word,
#define PUNCTUATION(name, text)
#define KEYWORD(text)
#define WORD(text) text,
#include "syntax/tokens.def"
#undef PUNCTUATION
#undef KEYWORD
#undef WORD
};

/// The meaning of a token whose spelling has several, such as `<`. Set by the parser, for the formatter.
enum class Role : std::uint8_t {
    none,
    open_generic,
    close_generic,  // `<` and `>` around generic parameters or arguments
    unary,          // a prefix operator
    optional,       // the `?` of a type
    open_tuple,
    close_tuple,  // the braces of `{ 1, 2 }`
    spaced,  // the `?` and `:` of a conditional; the `:` before `uint2 -> uint`, the types of a translator or structure
};

struct Token {
    TokenKind kind = TokenKind::end;
    Word word = Word::no_word;
    Role role = Role::none;
    bool first_on_line = false;
    std::uint32_t begin = 0, end = 0;
    Name name;  ///< identifiers and keywords
};

struct Comment {
    std::uint32_t begin = 0, end = 0;  ///< from the first slash; of a line comment, without the end of the line
    std::uint32_t next_token = 0;      ///< index of the token that follows
    bool is_doc = false;               ///< `///`
    bool first_on_line = false;
};

struct TokenList {
    std::vector<Token> tokens;
    std::vector<Comment> comments;
    bool has_open_string = false;  ///< there is an unterminated string, which may contain brackets meant as tokens
};

/// The kind as messages name it: "'{'", "'struct'", "a name".
std::string_view describe(TokenKind kind);

}  // namespace gliftc
