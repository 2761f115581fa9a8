// The requests that the server answers, a file for each: functions from a request's parameters to its result. They
// throw RequestError (lsp/protocol.h).
#pragma once

#include "lsp/workspace.h"

#include <nlohmann/json.hpp>

namespace gliftc::lsp {

/// textDocument/hover: the declaration, the type, a structure's properties, the `///` comment.
nlohmann::json hover(Workspace& workspace, const nlohmann::json& params);
/// textDocument/definition: the declarations of a name; all overloads if none is chosen.
nlohmann::json definition(Workspace& workspace, const nlohmann::json& params);
/// textDocument/references: uses in open documents and in the files of the folders.
nlohmann::json references(Workspace& workspace, const nlohmann::json& params);
/// textDocument/prepareRename and textDocument/rename: refuse built-in names, names in the library, new names that are
/// no names, and those with which a file has errors that it does not have now.
nlohmann::json prepare_rename(Workspace& workspace, const nlohmann::json& params);
nlohmann::json rename(Workspace& workspace, const nlohmann::json& params);
/// textDocument/completion: members after `.`, modules after `use`, patterns where a parameter's pattern stands, else
/// names in scope, and public names of modules that are not imported, with the `use` as an additional edit.
nlohmann::json completion(Workspace& workspace, const nlohmann::json& params);
/// textDocument/signatureHelp
nlohmann::json signature_help(Workspace& workspace, const nlohmann::json& params);
/// textDocument/documentSymbol
nlohmann::json document_symbols(Workspace& workspace, const nlohmann::json& params);
/// textDocument/semanticTokens/full, and the legend of its numbers.
nlohmann::json semantic_tokens(Workspace& workspace, const nlohmann::json& params);
nlohmann::json semantic_tokens_legend();
/// textDocument/formatting: what `gliftc fmt` does; no edits for a file that does not parse.
nlohmann::json formatting(Workspace& workspace, const nlohmann::json& params);
/// textDocument/codeAction: the fixes that notes of diagnostics in the range name.
nlohmann::json code_actions(Workspace& workspace, const nlohmann::json& params);
/// textDocument/codeLens: commands that the editor carries out: "glift.showGlsl" with {path, name of the kernel} and
/// "glift.runTest" with {path, title}.
nlohmann::json code_lenses(Workspace& workspace, const nlohmann::json& params);

/// The parameters of textDocument/publishDiagnostics for an open document: what `found` says of it, and of files that
/// it imports, at the places in the document that led there.
nlohmann::json diagnostics(const Workspace& workspace, const std::string& path, const Analysis& analysis,
                           const std::vector<Diagnostic>& found);

}  // namespace gliftc::lsp
