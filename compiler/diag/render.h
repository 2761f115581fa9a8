// Diagnostics as text for people and as JSON for tools.
#pragma once

#include "diag/diagnostics.h"

#include <string>

namespace gliftc {

/// Whether escape sequences colour the text; deciding what `auto` means is the caller's.
enum class Colour : std::uint8_t { plain, coloured };

/// `file:line:col: error: text [id]`, the line of source, carets under the words, then the notes alike.
std::string render_text(const Diagnostic& diagnostic, const Sources& sources, Colour colour);

/// All of them, and a last line that counts errors where the limit cut them off.
std::string render_text(const Diagnostics& diagnostics, const Sources& sources, Colour colour);

/// One JSON array; an object a diagnostic: id, severity, text, and where known file, line, column, end_line,
/// end_column; notes alike.
std::string render_json(const Diagnostics& diagnostics, const Sources& sources);

}  // namespace gliftc
