// Text to tokens.
#pragma once

#include "diag/diagnostics.h"
#include "syntax/token.h"

namespace gliftc {

/// Never fails: what is no token is reported and stands in the list as a bad character. The list ends with
/// TokenKind::end.
TokenList lex(std::uint32_t file, const Sources& sources, Names& names, Diagnostics& diagnostics);

/// The offset of the first byte that is not valid UTF-8; the text's size where all is.
std::size_t find_invalid_utf8(std::string_view text);

}  // namespace gliftc
