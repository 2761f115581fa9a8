// The lexer: text to tokens.
#pragma once

#include "diag/diagnostics.h"
#include "syntax/token.h"

namespace gliftc {

/// Never fails: text that begins no token is reported and becomes a bad_character token, but a word that mixes ASCII
/// and other characters an identifier. An unterminated string is reported and ends with its line, a comment with the
/// file. Malformed numbers (bad_number) are left to the parser to report. The list ends with TokenKind::end.
TokenList lex(std::uint32_t file, const Sources& sources, Names& names, Diagnostics& diagnostics);

/// The offset of the first byte that is not valid UTF-8; the text's size if all are.
std::size_t find_invalid_utf8(std::string_view text);

}  // namespace gliftc
