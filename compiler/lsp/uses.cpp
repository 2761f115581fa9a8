#include "lsp/uses.h"

#include "lsp/uris.h"

#include <algorithm>
#include <set>

namespace gliftc::lsp {

namespace {

/// The text of an open document, or of the file.
std::string text_of(const Workspace& workspace, const std::string& path) {
    return workspace.documents.overlay().read(path).text;
}

bool denotes_any(const std::vector<Declared>& found, const std::vector<Declared>& wanted) {
    return std::ranges::any_of(found,
                               [&](const Declared& each) { return std::ranges::find(wanted, each) != wanted.end(); });
}

}  // namespace

std::vector<Declared> declared_by(const Analysis& analysis, const Token& token) {
    std::vector<Declared> found;
    for (Span span : declarations_of(analysis, token))
        found.push_back({canonical(analysis.compilation.sources[span.file].path), span.begin, span.end});
    return found;
}

std::vector<FileUses> uses_of(Workspace& workspace, const std::vector<Declared>& declared, const std::string& name) {
    std::vector<FileUses> all;
    std::set<std::string> paths;
    for (const std::string& path : workspace.files()) paths.insert(path);
    for (const Declared& each : declared) paths.insert(each.path);
    for (const std::string& path : paths) {
        if (text_of(workspace, path).find(name) == std::string::npos) continue;
        FileUses uses{path, &workspace.analysis(path), {}, {}};
        if (uses.analysis->module == nullptr) continue;
        for (const Token& token : uses.analysis->tokens.tokens) {
            if (!is_name(token) || uses.analysis->text(token) != name) continue;
            const std::vector<Declared> found = declared_by(*uses.analysis, token);
            if (denotes_any(found, declared)) uses.names.push_back({0, token.begin, token.end});
            if (found.empty()) uses.unresolved.push_back({0, token.begin, token.end});
        }
        if (!uses.names.empty() || !uses.unresolved.empty()) all.push_back(std::move(uses));
    }
    return all;
}

}  // namespace gliftc::lsp
