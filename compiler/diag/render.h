// Diagnostics as text for people and as JSON for tools.
#pragma once

#include "diag/diagnostics.h"

#include <string>

namespace gliftc {

/// Whether escape sequences colour the text. `--color=auto` is resolved by the caller (driver/report.cpp).
enum class Colour : std::uint8_t { plain, coloured };

/// `file:line:col: error: text [id]`, the source line, carets under the span, then the notes in the same form, without
/// an id. What has no span has no location and no source line.
std::string render_text(const Diagnostic& diagnostic, const Sources& sources, Colour colour);

/// All diagnostics, each as above; a last line gives the number of errors where the limit was reached.
std::string render_text(const Diagnostics& diagnostics, const Sources& sources, Colour colour);

/// A JSON array with an object for each diagnostic: severity, id, text; file, line, column, end_line and end_column if
/// it has a location; and notes, an array of objects with a text and, if the note has a location, the same five fields.
std::string render_json(const Diagnostics& diagnostics, const Sources& sources);

}  // namespace gliftc
