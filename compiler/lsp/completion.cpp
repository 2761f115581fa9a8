#include "driver/declarations.h"
#include "lsp/builtins.h"
#include "lsp/features.h"
#include "lsp/imports.h"
#include "lsp/members.h"
#include "lsp/names.h"
#include "lsp/probes.h"

#include <algorithm>
#include <set>

namespace gliftc::lsp {

namespace {

constexpr int function_kind = 3, module_kind = 9, keyword_kind = 14, type_kind = 7;

nlohmann::json item_of(const Suggestion& suggestion) {
    nlohmann::json item = {{"label", suggestion.name}, {"kind", suggestion.kind}};
    if (!suggestion.detail.empty()) item["detail"] = suggestion.detail;
    if (!suggestion.doc.empty()) item["documentation"] = {{"kind", "markdown"}, {"value", suggestion.doc}};
    return item;
}

/// Whether the offset is inside of a comment or a string, where nothing is completed.
bool is_in_text(const Analysis& analysis, std::size_t offset) {
    const auto is_inside = [&](std::uint32_t begin, std::uint32_t end) { return begin < offset && offset <= end; };
    for (const Comment& comment : analysis.tokens.comments)
        if (is_inside(comment.begin, comment.end)) return true;
    for (const Token& token : analysis.tokens.tokens)
        if (token.kind == TokenKind::string && token.begin < offset && offset < token.end) return true;
    return false;
}

/// The text between `use` and the offset, if the line is an import.
std::optional<std::string_view> written_import(std::string_view text, std::size_t offset) {
    std::string_view line = text.substr(0, offset);
    line.remove_prefix(line.rfind('\n') == std::string_view::npos ? 0 : line.rfind('\n') + 1);
    while (line.starts_with(' ')) line.remove_prefix(1);
    if (!line.starts_with("use ") || line.find(';') != std::string_view::npos) return std::nullopt;
    return line.substr(4);
}

/// The modules whose names begin with what is written. An item replaces the name's last part alone: editors take dots
/// as ends of words.
nlohmann::json modules(const Workspace& workspace, const Place& place, std::string_view written) {
    const std::size_t dot = written.rfind('.');
    const std::size_t typed = dot == std::string_view::npos ? 0 : dot + 1;
    Options options = workspace.options();
    options.files = {place.path};
    nlohmann::json items = nlohmann::json::array();
    std::set<std::string> seen;
    for (const std::string& module : importable_modules(options, workspace.documents.overlay())) {
        if (!module.starts_with(written) || !seen.insert(module).second) continue;
        items.push_back({{"label", module.substr(typed)}, {"kind", module_kind}, {"detail", "use " + module + ";"}});
    }
    return items;
}

nlohmann::json members(const Workspace& workspace, const Place& place, std::size_t dot, Written written) {
    const auto probed = probe(workspace, place.path, place.analysis.text(), written);
    const std::size_t end = last_before(place.analysis.text(), dot);
    nlohmann::json items = nlohmann::json::array();
    if (end == std::string_view::npos) return items;
    for (const Suggestion& member : members_before(*probed, end + 1)) items.push_back(item_of(member));
    return items;
}

/// Whether an access pattern may stand at the offset: behind `in`, `out` or `inout`.
bool is_after_direction(std::string_view text, std::size_t offset) {
    const std::size_t last = last_before(text, offset);
    if (last == std::string_view::npos || last + 1 == offset) return false;
    const Written word = name_before(text, last + 1);
    const std::string_view before = text.substr(word.begin, word.end - word.begin);
    return before == "in" || before == "out" || before == "inout";
}

void add_patterns(nlohmann::json& items) {
    for (const Pattern& pattern : patterns())
        items.push_back({{"label", pattern.name},
                         {"kind", keyword_kind},
                         {"documentation", pattern.text},
                         {"sortText", "0" + std::string(pattern.name)}});
}

void add_builtins(nlohmann::json& items) {
    for (const BuiltinFunction& function : builtin_functions())
        items.push_back({{"label", function.name},
                         {"kind", function_kind},
                         {"detail", function.signature()},
                         {"sortText", "3" + std::string(function.name)}});
    for (std::string_view type : builtin_types())
        items.push_back({{"label", type}, {"kind", type_kind}, {"sortText", "4" + std::string(type)}});
    for (std::string_view word : keywords())
        items.push_back({{"label", word}, {"kind", keyword_kind}, {"sortText", "5" + std::string(word)}});
}

/// Adds public names of modules that are not imported, each with the edit that imports its module.
void add_missing_imports(const Workspace& workspace, const Place& place, std::string_view prefix,
                         std::set<std::string>& seen, nlohmann::json& items) {
    if (prefix.empty()) return;
    Options options = workspace.options();
    options.files = {place.path};
    for (const PublicName& name : public_names(options, workspace.documents.overlay(), prefix)) {
        const auto edit = import_edit(place.analysis, name.module);
        if (!edit || !seen.insert(name.name).second) continue;
        items.push_back({{"label", name.name},
                         {"kind", name.word == "structure" ? type_kind : function_kind},
                         {"detail", name.word + ", use " + name.module},
                         {"sortText", "6" + name.name},
                         {"additionalTextEdits", nlohmann::json::array({*edit})}});
    }
}

nlohmann::json names(const Workspace& workspace, const Place& place, Written written) {
    const std::string_view text = place.analysis.text();
    nlohmann::json items = nlohmann::json::array();
    std::set<std::string> seen;
    if (is_after_direction(text, written.begin)) add_patterns(items);
    for (const Entity* entity : visible_at(place.analysis, written.begin)) {
        const Suggestion suggestion = suggestion_of(place.analysis, *entity);
        const bool is_written_here = entity->name.span == Span{0, static_cast<std::uint32_t>(written.begin),
                                                               static_cast<std::uint32_t>(written.end)};
        if (is_written_here || !seen.insert(suggestion.name).second) continue;
        nlohmann::json item = item_of(suggestion);
        item["sortText"] = (entity->name.span.file == 0 ? "1" : "2") + suggestion.name;
        items.push_back(std::move(item));
    }
    add_builtins(items);
    add_missing_imports(workspace, place, text.substr(written.begin, written.end - written.begin), seen, items);
    return items;
}

nlohmann::json items_at(const Workspace& workspace, const Place& place) {
    const std::string_view text = place.analysis.text();
    if (is_in_text(place.analysis, place.offset)) return nlohmann::json::array();
    if (const auto import = written_import(text, place.offset)) return modules(workspace, place, *import);
    const Written written = name_before(text, place.offset);
    const std::size_t last = last_before(text, written.begin);
    const bool follows_dot =
        last != std::string_view::npos && text[last] == '.' && (last == 0 || text[last - 1] != '.');
    return follows_dot ? members(workspace, place, last, written) : names(workspace, place, written);
}

}  // namespace

nlohmann::json completion(Workspace& workspace, const nlohmann::json& params) {
    const Place place = place_in(workspace, params);
    return {{"isIncomplete", true}, {"items", items_at(workspace, place)}};
}

}  // namespace gliftc::lsp
