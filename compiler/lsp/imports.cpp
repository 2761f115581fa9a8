#include "lsp/imports.h"

#include "lsp/positions.h"

#include <nlohmann/json.hpp>

namespace gliftc::lsp {

namespace {

/// The beginning of the line that contains the offset, and of the line after it.
std::size_t line_begin(std::string_view text, std::size_t offset) {
    const std::size_t before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
    return before == std::string_view::npos ? 0 : before + 1;
}

std::size_t next_line(std::string_view text, std::size_t offset) {
    const std::size_t end = text.find('\n', offset);
    return end == std::string_view::npos ? text.size() : end + 1;
}

nlohmann::json insertion(std::string_view text, std::size_t at, std::string inserted) {
    // At the end of a text without a final line break, the import begins a line of its own.
    if (at == text.size() && !text.empty() && text.back() != '\n') inserted = "\n" + inserted;
    return {{"range", range_of(text, at, at)}, {"newText", inserted}};
}

}  // namespace

std::optional<nlohmann::json> import_edit(const Analysis& analysis, const std::string& module) {
    if (analysis.module == nullptr || analysis.compilation.names[analysis.module->name.name] == module)
        return std::nullopt;
    const std::string line = "use " + module + ";\n";
    const std::string_view text = analysis.text();
    for (const ast::Use& use : analysis.module->uses)
        if (use.path == module) return std::nullopt;
    for (const ast::Use& use : analysis.module->uses)
        if (use.path > module) return insertion(text, line_begin(text, use.span.begin), line);
    if (!analysis.module->uses.empty())
        return insertion(text, next_line(text, analysis.module->uses.back().span.end), line);
    const Span header = analysis.module->name.span;
    return header ? insertion(text, next_line(text, header.end), "\n" + line) : insertion(text, 0, line);
}

}  // namespace gliftc::lsp
