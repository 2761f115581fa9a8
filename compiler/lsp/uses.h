// All places where a declaration's name is written, in the files of the workspace.
#pragma once

#include "lsp/names.h"
#include "lsp/workspace.h"

#include <string>
#include <vector>

namespace gliftc::lsp {

/// A declaration, independent of a compilation: the canonical path of its file, and its name's place there.
struct Declared {
    std::string path;
    std::uint32_t begin = 0, end = 0;
    bool operator==(const Declared&) const = default;
};

/// The declarations that a token denotes. Empty if it denotes none that is known.
std::vector<Declared> declared_by(const Analysis& analysis, const Token& token);

struct FileUses {
    std::string path;
    const Analysis* analysis = nullptr;
    std::vector<Span> names;       ///< uses, and the declaration itself if it is in this file
    std::vector<Span> unresolved;  ///< the same name, where it is not known what it denotes
};

/// The uses of declarations that share one name, file by file. Analyses every file of the workspace in which the name
/// occurs, which takes some 10 ms for each.
std::vector<FileUses> uses_of(Workspace& workspace, const std::vector<Declared>& declared, const std::string& name);

}  // namespace gliftc::lsp
