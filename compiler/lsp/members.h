// The members that may follow a dot.
#pragma once

#include "lsp/analysis.h"

#include <string>
#include <vector>

namespace gliftc::lsp {

/// A name that may stand somewhere, for a list of suggestions. `entity` is its declaration, null for names of the
/// language.
struct Suggestion {
    std::string name;
    std::string detail;  ///< its type or declaration
    std::string doc;
    int kind = 6;  ///< the protocol's CompletionItemKind
    const Entity* entity = nullptr;
};

Suggestion suggestion_of(const Analysis& analysis, const Entity& entity);

/// The members of what ends at byte `end`, just before the dot: of a value, a structure, a module, an enum. Empty if
/// sema does not know what stands there.
std::vector<Suggestion> members_before(const Analysis& analysis, std::size_t end);

}  // namespace gliftc::lsp
