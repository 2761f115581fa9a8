#include "driver/file_system.h"
#include "lsp/features.h"
#include "lsp/positions.h"
#include "lsp/uris.h"

#include <algorithm>

namespace gliftc::lsp {

namespace {

int severity_number(Severity severity) {
    return severity == Severity::error ? 1 : severity == Severity::warning ? 2 : 3;
}

/// The place in the document where a diagnostic is shown: its own place, else that of the first note in the document,
/// else the first import, else the beginning of the file.
Span place_in_document(const Analysis& analysis, const Diagnostic& diagnostic) {
    if (diagnostic.span && diagnostic.span.file == 0) return diagnostic.span;
    for (const Note& note : diagnostic.notes)
        if (note.span && note.span.file == 0) return note.span;
    const bool has_import = diagnostic.span && analysis.module != nullptr && !analysis.module->uses.empty();
    return has_import ? analysis.module->uses.front().span : Span{0, 0, 0};
}

/// The example of the diagnostic, which `gliftc explain` prints, as a file URI; empty if there is none.
std::string explanation_of(Diag id) {
    std::string name(id_of(id));
    std::replace(name.begin(), name.end(), '-', '_');
    const std::string path = canonical(diagnostics_beside_executable() + "/" + name + ".glift");
    return disk().exists(path) ? uri_of(path) : std::string();
}

nlohmann::json related(const Workspace& workspace, const Analysis& analysis, const Diagnostic& diagnostic, Span shown) {
    nlohmann::json notes = nlohmann::json::array();
    const auto add = [&](Span span, const std::string& text) {
        notes.push_back({{"location", location(workspace, analysis, span)}, {"message", text}});
    };
    if (diagnostic.span && diagnostic.span != shown) add(diagnostic.span, diagnostic.text);
    for (const Note& note : diagnostic.notes) add(note.span ? note.span : shown, note.text);
    return notes;
}

nlohmann::json to_json(const Workspace& workspace, const Analysis& analysis, const Diagnostic& diagnostic) {
    const Span shown = place_in_document(analysis, diagnostic);
    nlohmann::json made = {{"range", range_of(analysis.compilation.sources, shown)},
                           {"severity", severity_number(diagnostic.severity)},
                           {"code", id_of(diagnostic.id)},
                           {"source", "gliftc"},
                           {"message", diagnostic.text},
                           {"relatedInformation", related(workspace, analysis, diagnostic, shown)}};
    if (std::string explanation = explanation_of(diagnostic.id); !explanation.empty())
        made["codeDescription"] = {{"href", explanation}};
    if (diagnostic.id == Diag::unused_variable) made["tags"] = {1};
    return made;
}

}  // namespace

nlohmann::json diagnostics(const Workspace& workspace, const std::string& path, const Analysis& analysis,
                           const std::vector<Diagnostic>& found) {
    nlohmann::json list = nlohmann::json::array();
    if (analysis.compilation.sources.size() > 0)
        for (const Diagnostic& diagnostic : found) list.push_back(to_json(workspace, analysis, diagnostic));
    nlohmann::json params = {{"uri", uri_of(path)}, {"diagnostics", std::move(list)}};
    if (const Document* document = workspace.documents.find(path)) {
        params["uri"] = document->uri;
        params["version"] = document->version;
    }
    return params;
}

}  // namespace gliftc::lsp
