// What a session knows: options, open documents, folders, and the analyses of files, which are made when they are asked
// for and kept until a file that they read changes.
#pragma once

#include "lsp/analysis.h"
#include "lsp/documents.h"

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace gliftc::lsp {

class Workspace {
public:
    explicit Workspace(Options options) : options_(std::move(options)) {}

    Documents documents;
    std::vector<std::string> folders;  ///< of the editor's workspace

    const Options& options() const { return options_; }
    const Analysis& analysis(const std::string& path);
    /// Whether the analysis of a file, if there is one, read another file.
    bool reads(const std::string& path, const std::string& other) const;
    /// Drops the analyses that read the file; of all files if `path` is empty.
    void forget(const std::string& path);
    /// The .glift files that may refer to a declaration: open documents and files in the folders.
    std::vector<std::string> files() const;
    /// What `gliftc --check` reports beyond the analysis, such as errors of lowering. Takes several times as long.
    std::vector<Diagnostic> errors_of_lowering(const std::string& path) const;

private:
    Options options_;
    std::map<std::string, std::unique_ptr<Analysis>> analyses_;
};

/// A position in a document, as requests name it.
struct Place {
    std::string path;
    const Analysis& analysis;
    std::size_t offset;
    const Token* token;  ///< at the offset (lsp/names.h); may be null
};

/// Throws InvalidParams if the parameters name no document and position, or the file cannot be read.
Place place_in(Workspace& workspace, const nlohmann::json& params);
/// The analysis of the document that the parameters name. Throws InvalidParams.
const Analysis& analysis_in(Workspace& workspace, const nlohmann::json& params);

/// The URI of a file of the compilation, in the editor's form if it is open.
std::string uri_of(const Workspace& workspace, const Analysis& analysis, std::uint32_t file);
nlohmann::json location(const Workspace& workspace, const Analysis& analysis, Span span);

}  // namespace gliftc::lsp
