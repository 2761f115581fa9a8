// The parser: tokens to the syntax tree. The grammar is docs/reference/grammar.ebnf; most parsing functions have their
// rule above them.
#pragma once

#include "diag/diagnostics.h"
#include "syntax/ast.h"
#include "syntax/token.h"

namespace gliftc {

/// Never fails: a syntax error is reported, and the construct that has it becomes an error node, is left out, or lacks
/// what could not be read.
ast::Module parse(std::uint32_t file, const Sources& sources, Names& names, ast::Tree& tree, Diagnostics& diagnostics);

/// The same for a file that has been lexed. Sets the roles of the tokens. A token that it consumes in parts, such as
/// `>>` as two closing `>`, is shortened to the last part.
ast::Module parse(TokenList& tokens, std::uint32_t file, const Sources& sources, Names& names, ast::Tree& tree,
                  Diagnostics& diagnostics);

}  // namespace gliftc
