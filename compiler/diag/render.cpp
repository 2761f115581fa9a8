#include "diag/render.h"

#include <algorithm>

namespace gliftc {

namespace {

constexpr std::string_view bold = "\x1b[1m", red = "\x1b[1;31m", magenta = "\x1b[1;35m", cyan = "\x1b[1;36m",
                           green = "\x1b[1;32m", reset = "\x1b[0m";

std::string_view word_of(Severity severity) {
    switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: return "error";
    }
    return "";
}

std::string_view colour_of(Severity severity) {
    switch (severity) {
    case Severity::note: return cyan;
    case Severity::warning: return magenta;
    case Severity::error: return red;
    }
    return "";
}

struct Painter {
    Colour colour;
    std::string operator()(std::string_view style, std::string_view text) const {
        if (colour == Colour::plain) return std::string(text);
        return std::string(style) + std::string(text) + std::string(reset);
    }
};

std::string place(Span span, const Sources& sources) {
    Position at = sources.position(span);
    return sources[span.file].path + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": ";
}

/// Whether a byte of UTF-8 begins a character.
bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

/// A source line for terminals, and the carets below it. ASCII control characters other than tabs become spaces; of
/// a long line about `widest` bytes are shown, around the beginning of the span.
struct Shown {
    std::string line, carets;
};

Shown show_line(Span span, const Sources& sources) {
    constexpr std::size_t widest = 160;
    Position at = sources.position(span);
    std::string_view line = sources.line(span.file, at.line);
    std::size_t line_begin = sources[span.file].line_starts[at.line - 1];
    std::size_t begin = std::min<std::size_t>(span.begin - line_begin, line.size());
    std::size_t end = std::clamp<std::size_t>(span.end < line_begin ? 0 : span.end - line_begin, begin, line.size());
    std::size_t from = 0;
    if (line.size() > widest && begin > widest / 2) {
        from = begin - widest / 2;
        while (from > 0 && !begins_character(line[from])) --from;
    }
    Shown shown;
    for (std::size_t i = from; i < line.size(); ++i) {
        if (i - from >= widest && begins_character(line[i])) break;
        char c = line[i];
        bool control = static_cast<unsigned char>(c) < 0x20 && c != '\t';
        shown.line += control || c == 0x7f ? ' ' : c;
        if (!begins_character(c)) continue;
        // A tab under a tab keeps the carets aligned for every tab width of the terminal.
        if (i < begin) shown.carets += c == '\t' ? '\t' : ' ';
        if (i >= begin && i < end) shown.carets += i == begin ? '^' : '~';
    }
    if (shown.carets.find('^') == std::string::npos) shown.carets += '^';
    return shown;
}

void append(std::string& out, Severity severity, Span span, std::string_view text, std::string_view id,
            const Sources& sources, Painter paint) {
    if (span) out += paint(bold, place(span, sources));
    out += paint(colour_of(severity), std::string(word_of(severity)) + ": ");
    out += severity == Severity::note ? std::string(text) : paint(bold, text);
    if (!id.empty()) out += " [" + std::string(id) + "]";
    out += '\n';
    if (!span) return;
    Shown shown = show_line(span, sources);
    out += "    " + shown.line + "\n    " + paint(green, shown.carets) + "\n";
}

std::string quoted(std::string_view text) {
    constexpr char digits[] = "0123456789abcdef";
    std::string out = "\"";
    for (char c : text) {
        switch (c) {
        case '"': out += "\\\""; continue;
        case '\\': out += "\\\\"; continue;
        case '\n': out += "\\n"; continue;
        case '\t': out += "\\t"; continue;
        }
        auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20) {
            out += "\\u00";
            out += digits[byte >> 4];
            out += digits[byte & 15];
        } else {
            out += c;
        }
    }
    return out + "\"";
}

void append_json_place(std::string& out, Span span, const Sources& sources) {
    if (!span) return;
    Position begin = sources.position(span);
    Position end = sources.position({span.file, span.end, span.end});
    out += ", \"file\": " + quoted(sources[span.file].path) + ", \"line\": " + std::to_string(begin.line) +
           ", \"column\": " + std::to_string(begin.column) + ", \"end_line\": " + std::to_string(end.line) +
           ", \"end_column\": " + std::to_string(end.column);
}

}  // namespace

std::string render_text(const Diagnostic& diagnostic, const Sources& sources, Colour colour) {
    std::string out;
    Painter paint{colour};
    append(out, diagnostic.severity, diagnostic.span, diagnostic.text, id_of(diagnostic.id), sources, paint);
    for (const Note& note : diagnostic.notes) append(out, Severity::note, note.span, note.text, {}, sources, paint);
    return out;
}

std::string render_text(const Diagnostics& diagnostics, const Sources& sources, Colour colour) {
    std::string out;
    for (const Diagnostic& diagnostic : diagnostics.all()) out += render_text(diagnostic, sources, colour);
    if (diagnostics.at_limit())
        out += "note: " + std::to_string(diagnostics.error_count()) +
               (diagnostics.error_count() == 1 ? " error" : " errors") + "; no more are shown (--error-limit)\n";
    return out;
}

std::string render_json(const Diagnostics& diagnostics, const Sources& sources) {
    std::string out = "[";
    bool first = true;
    for (const Diagnostic& diagnostic : diagnostics.all()) {
        out += first ? "\n" : ",\n";
        first = false;
        out += "  {\"severity\": " + quoted(word_of(diagnostic.severity)) +
               ", \"id\": " + quoted(id_of(diagnostic.id)) + ", \"text\": " + quoted(diagnostic.text);
        append_json_place(out, diagnostic.span, sources);
        out += ", \"notes\": [";
        for (std::size_t i = 0; i < diagnostic.notes.size(); ++i) {
            const Note& note = diagnostic.notes[i];
            out += (i ? ", {\"text\": " : "{\"text\": ") + quoted(note.text);
            append_json_place(out, note.span, sources);
            out += "}";
        }
        out += "]}";
    }
    return out + (first ? "]\n" : "\n]\n");
}

}  // namespace gliftc
