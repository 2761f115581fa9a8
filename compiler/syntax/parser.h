// Tokens to the tree. The grammar is docs/grammar.ebnf; each parsing function carries its rule.
#pragma once

#include "diag/diagnostics.h"
#include "syntax/ast.h"
#include "syntax/token.h"

namespace gliftc {

/// Never fails: what cannot be read is reported and stands in the tree as an error node, or is left out.
ast::Module parse(std::uint32_t file, const Sources& sources, Names& names, ast::Tree& tree, Diagnostics& diagnostics);

/// The same from tokens that are there already; writes the roles of the tokens.
ast::Module parse(TokenList& tokens, std::uint32_t file, const Sources& sources, Names& names, ast::Tree& tree,
                  Diagnostics& diagnostics);

}  // namespace gliftc
