// The lexer: text to tokens.
#pragma once

#include "diag/diagnostics.h"
#include "syntax/token.h"

namespace gliftc {

/// Never fails. Text that begins no token is reported and becomes a bad_character token; a word that mixes ASCII and
/// other characters is reported and becomes an identifier. An unterminated string is reported and ends with its line;
/// an unterminated comment is reported and ends with the file. The parser reports malformed numbers (bad_number). If
/// the text is not valid UTF-8, that is reported once, and characters beyond ASCII are not reported one by one. The
/// list ends with TokenKind::end.
TokenList lex(std::uint32_t file, const Sources& sources, Names& names, Diagnostics& diagnostics);

/// The offset of the first byte that is not valid UTF-8; the text's size if all are.
std::size_t find_invalid_utf8(std::string_view text);

}  // namespace gliftc
