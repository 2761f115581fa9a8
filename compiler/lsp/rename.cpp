#include "lsp/features.h"
#include "lsp/positions.h"
#include "lsp/protocol.h"
#include "lsp/uris.h"
#include "lsp/uses.h"
#include "syntax/lexer.h"

#include <algorithm>
#include <map>

namespace gliftc::lsp {

namespace {

[[noreturn]] void refuse(const std::string& text) { throw RequestError(ErrorCode::request_failed, text); }

/// The declarations to rename; refuses a place where there are none, and declarations in the library unless that is
/// what the workspace is about.
std::vector<Declared> renamed(const Workspace& workspace, const Place& place) {
    if (place.token == nullptr || !is_name(*place.token)) refuse("there is no name here");
    const std::string name(place.analysis.text(*place.token));
    std::vector<Declared> declared = declared_by(place.analysis, *place.token);
    if (declared.empty())
        refuse("'" + name + "' is not declared in a .glift file, or code that is not checked uses it");
    const std::vector<std::string> files = workspace.files();
    for (const Declared& each : declared) {
        const bool is_own = std::ranges::find(files, each.path) != files.end();
        if (!is_own) refuse("'" + name + "' is declared outside of the workspace, in '" + each.path + "'");
    }
    return declared;
}

/// Whether the text is one identifier.
bool is_identifier(const std::string& text) {
    Sources sources;
    Names names;
    Diagnostics diagnostics;
    const TokenList list = lex(sources.add("name", text), sources, names, diagnostics);
    return !diagnostics.has_errors() && list.comments.empty() && list.tokens.size() == 2 && is_name(list.tokens[0]) &&
           list.tokens[0].end - list.tokens[0].begin == text.size();
}

std::string renamed_text(const FileUses& uses, const std::string& name) {
    std::string text = uses.analysis->text();
    for (auto span = uses.names.rbegin(); span != uses.names.rend(); ++span)
        text.replace(span->begin, span->end - span->begin, name);
    return text;
}

/// Refuses if a file has errors with the new name that it does not have now.
void check_result(const Workspace& workspace, const std::vector<FileUses>& all, const std::string& name) {
    std::map<std::string, std::string> texts;
    for (const FileUses& uses : all)
        if (!uses.names.empty()) texts[uses.path] = renamed_text(uses, name);
    FileSystem files = workspace.documents.overlay();
    files.read = [&texts, read = files.read](const std::string& path) {
        const auto found = texts.find(canonical(path));
        return found == texts.end() ? read(path) : ReadResult{found->second, {}};
    };
    for (const FileUses& uses : all) {
        if (uses.names.empty()) continue;
        const auto after = analyse(workspace.options(), files, uses.path);
        const Diagnostics& errors = after->compilation.diagnostics;
        if (errors.error_count() <= uses.analysis->compilation.diagnostics.error_count()) continue;
        for (const Diagnostic& error : errors.all())
            if (error.severity == Severity::error)
                refuse("with the name '" + name + "' there is an error in '" + uses.path + "': " + error.text);
    }
}

}  // namespace

nlohmann::json prepare_rename(Workspace& workspace, const nlohmann::json& params) {
    const Place place = place_in(workspace, params);
    renamed(workspace, place);
    return {{"range", range_of(place.analysis.text(), place.token->begin, place.token->end)},
            {"placeholder", place.analysis.text(*place.token)}};
}

nlohmann::json rename(Workspace& workspace, const nlohmann::json& params) {
    const std::string& name = string_member(params, "newName");
    const Place place = place_in(workspace, params);
    const std::vector<Declared> declared = renamed(workspace, place);
    if (!is_identifier(name)) refuse("'" + name + "' is no name of the language");
    const std::vector<FileUses> all = uses_of(workspace, declared, std::string(place.analysis.text(*place.token)));
    check_result(workspace, all, name);
    nlohmann::json changes = nlohmann::json::object();
    for (const FileUses& uses : all) {
        nlohmann::json edits = nlohmann::json::array();
        for (Span span : uses.names)
            edits.push_back({{"range", range_of(uses.analysis->compilation.sources, span)}, {"newText", name}});
        if (!edits.empty()) changes[uri_of(workspace, *uses.analysis, 0)] = std::move(edits);
    }
    return {{"changes", std::move(changes)}};
}

}  // namespace gliftc::lsp
