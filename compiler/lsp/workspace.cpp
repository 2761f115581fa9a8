#include "lsp/workspace.h"

#include "driver/commands.h"
#include "lsp/names.h"
#include "lsp/positions.h"
#include "lsp/protocol.h"
#include "lsp/uris.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace gliftc::lsp {

namespace {

namespace fs = std::filesystem;

/// Folders with more files than this are searched no further.
constexpr std::size_t most_files = 2000;

bool has_read(const Analysis& analysis, const std::string& path) {
    const Sources& sources = analysis.compilation.sources;
    for (std::uint32_t file = 0; file < sources.size(); ++file)
        if (canonical(sources[file].path) == path) return true;
    return false;
}

void add_files(const std::string& folder, std::set<std::string>& files) {
    std::error_code error;
    auto entry = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator() && files.size() < most_files; entry.increment(error)) {
        const fs::path& path = entry->path();
        const bool is_hidden = path.filename().string().starts_with('.') || path.filename() == "build";
        if (is_hidden && entry->is_directory(error)) entry.disable_recursion_pending();
        else if (path.extension() == ".glift" && entry->is_regular_file(error)) files.insert(canonical(path.string()));
    }
}

std::string document_path(const nlohmann::json& params) {
    return path_of(string_member(member(params, "textDocument"), "uri"));
}

}  // namespace

const Analysis& Workspace::analysis(const std::string& path) {
    std::unique_ptr<Analysis>& found = analyses_[path];
    if (!found) found = analyse(options_, documents.overlay(), path);
    return *found;
}

bool Workspace::reads(const std::string& path, const std::string& other) const {
    const auto found = analyses_.find(path);
    return found != analyses_.end() && found->second && has_read(*found->second, other);
}

void Workspace::forget(const std::string& path) {
    std::erase_if(analyses_, [&](const auto& entry) {
        return path.empty() || entry.first == path || !entry.second || has_read(*entry.second, path);
    });
}

std::vector<std::string> Workspace::files() const {
    std::set<std::string> found;
    for (const auto& [path, document] : documents.all()) found.insert(path);
    for (const std::string& folder : folders) add_files(folder, found);
    return {found.begin(), found.end()};
}

std::vector<Diagnostic> Workspace::errors_of_lowering(const std::string& path) const {
    Options options = options_;
    options.files = {path};
    options.check_only = true;
    Compilation compilation;
    configure(compilation.diagnostics, options);
    compile(options, documents.overlay(), compilation);
    return compilation.diagnostics.all();
}

const Analysis& analysis_in(Workspace& workspace, const nlohmann::json& params) {
    const std::string path = document_path(params);
    const Analysis& analysis = workspace.analysis(path);
    if (analysis.module == nullptr) throw InvalidParams("the file '" + path + "' cannot be read");
    return analysis;
}

Place place_in(Workspace& workspace, const nlohmann::json& params) {
    const TextPosition position = read_position(member(params, "position"));
    const Analysis& analysis = analysis_in(workspace, params);
    const std::size_t offset = offset_of(analysis.text(), position);
    return {document_path(params), analysis, offset, token_at(analysis, offset)};
}

std::string uri_of(const Workspace& workspace, const Analysis& analysis, std::uint32_t file) {
    const std::string path = canonical(analysis.compilation.sources[file].path);
    const Document* document = workspace.documents.find(path);
    return document != nullptr ? document->uri : uri_of(path);
}

nlohmann::json location(const Workspace& workspace, const Analysis& analysis, Span span) {
    return {{"uri", uri_of(workspace, analysis, span.file)}, {"range", range_of(analysis.compilation.sources, span)}};
}

}  // namespace gliftc::lsp
