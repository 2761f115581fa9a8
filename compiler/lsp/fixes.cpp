#include "lsp/fixes.h"

namespace gliftc::lsp {

namespace {

/// What stands between the two texts, if the whole begins with the one and ends with the other.
std::optional<std::string> between(std::string_view whole, std::string_view begin, std::string_view end) {
    if (whole.size() < begin.size() + end.size() || !whole.starts_with(begin) || !whole.ends_with(end))
        return std::nullopt;
    return std::string(whole.substr(begin.size(), whole.size() - begin.size() - end.size()));
}

/// The import that a note names: `module std.reduce has it: 'use std.reduce;'`.
std::optional<std::string> named_import(std::string_view note) {
    const std::size_t quote = note.find(" has it: 'use ");
    if (!note.starts_with("module ") || quote == std::string_view::npos) return std::nullopt;
    return std::string(note.substr(7, quote - 7));
}

std::optional<Fix> fix_of_note(const Analysis& analysis, const Diagnostic& diagnostic, const Note& note) {
    const Span place = note.span ? note.span : diagnostic.span;
    if (!place) return std::nullopt;
    if (const auto module = named_import(note.text)) return Fix{"import " + *module, {}, {}, *module};
    if (const auto name = between(note.text, "did you mean '", "'?"))
        return Fix{"replace by '" + *name + "'", place, *name, {}};
    if (note.text == "write 'pub' before it to export it") {
        const Entity* entity = analysis.entity_at(note.span);
        const std::string_view text = entity ? analysis.compilation.sources.text(entity->written) : std::string_view();
        if (text.empty() || text.starts_with('@')) return std::nullopt;  // the word stands behind attributes
        const Span begin{place.file, entity->written.begin, entity->written.begin};
        return Fix{"export it by 'pub'", begin, "pub ", {}};
    }
    if (diagnostic.id == Diag::unused_variable)
        return Fix{"begin the name with '_'", Span{place.file, place.begin, place.begin}, "_", {}};
    return std::nullopt;
}

}  // namespace

std::vector<Fix> fixes_of(const Analysis& analysis, const Diagnostic& diagnostic) {
    std::vector<Fix> fixes;
    if (diagnostic.id == Diag::expected && diagnostic.text.starts_with("expected ';'") && diagnostic.span)
        fixes.push_back(
            {"insert ';'", Span{diagnostic.span.file, diagnostic.span.begin, diagnostic.span.begin}, ";", {}});
    for (const Note& note : diagnostic.notes)
        if (const auto fix = fix_of_note(analysis, diagnostic, note)) fixes.push_back(*fix);
    return fixes;
}

}  // namespace gliftc::lsp
