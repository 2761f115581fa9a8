// Completing unfinished code: the document is analysed with a name put in where the cursor is, so that the parser has
// an expression there.
#pragma once

#include "lsp/workspace.h"

#include <memory>

namespace gliftc::lsp {

/// The place of the name that is being written at an offset.
struct Written {
    std::size_t begin = 0, end = 0;  ///< the characters before the cursor that belong to the name
};

Written name_before(std::string_view text, std::size_t offset);

/// The last byte before `offset` that is no white space, as an index; npos if there is none.
std::size_t last_before(std::string_view text, std::size_t offset);

/// The document with the written name replaced by one that nothing declares. Bytes before `written.begin` stay where
/// they are.
std::unique_ptr<Analysis> probe(const Workspace& workspace, const std::string& path, std::string_view text,
                                Written written);

}  // namespace gliftc::lsp
