// The changes to the source that diagnostics name: mechanical ones, which an editor can offer to make.
#pragma once

#include "lsp/analysis.h"

#include <optional>
#include <string>
#include <vector>

namespace gliftc::lsp {

/// Replaces the bytes of the span by a text.
struct Fix {
    std::string title;
    Span replaced;
    std::string text;
    std::string import;  ///< the module to import; then `replaced` and `text` do not count
};

/// The fixes for one diagnostic, which may be in other files of the compilation:
/// - `did you mean 'x'?`: the other name;
/// - `module m has it: 'use m;'`: the import;
/// - `write 'pub' before it to export it`: the word, at the declaration;
/// - `a name that begins with '_' may stay unused`: the underscore;
/// - `expected ';'`: the semicolon.
std::vector<Fix> fixes_of(const Analysis& analysis, const Diagnostic& diagnostic);

}  // namespace gliftc::lsp
