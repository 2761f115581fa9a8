// What the front end knows of one document: its own files, trees and program, and the index of its names.
#pragma once

#include "driver/compile.h"
#include "lsp/entities.h"
#include "sema/index.h"
#include "syntax/token.h"

#include <map>
#include <memory>

namespace gliftc::lsp {

/// The document is file 0 of the compilation's sources; the files that it imports follow.
struct Analysis {
    Compilation compilation;
    sema::Index recorded;  ///< in the order of checking
    TokenList tokens;      ///< of the document
    std::string failure;   ///< the text of an exception that ended the analysis early; else empty

    const ast::Module* module = nullptr;  ///< of the document; null if it could not be read

    const std::string& text() const { return compilation.sources[0].text; }
    std::string_view text(const Token& token) const {
        return std::string_view(text()).substr(token.begin, token.end - token.begin);
    }
    /// The index with uses sorted by name, and types by the end of their spans; entries for one span are in the order
    /// of checking. The first call sorts it, which takes longer than diagnostics should wait.
    const sema::Index& index() const;
    /// What a file declares. Empty for a file that is no module of the compilation.
    const std::vector<Entity>& entities(std::uint32_t file) const;
    /// The entity whose name is declared at this place; null if there is none.
    const Entity* entity_at(Span declared) const;

private:
    mutable sema::Index sorted_;
    mutable bool is_sorted_ = false;
    mutable std::map<std::uint32_t, std::vector<Entity>> entities_;
};

/// Runs the front end on the file at `path` and what it imports. After an error that ends a compilation, later stages
/// still run, as far as they can, and report nothing. Never throws.
std::unique_ptr<Analysis> analyse(const Options& options, const FileSystem& files, const std::string& path);

}  // namespace gliftc::lsp
