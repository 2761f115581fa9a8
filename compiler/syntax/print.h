// The tree as S-expressions, for `--dump=syntax`, the parser's tests, and sema, which compares types by their text.
#pragma once

#include "syntax/ast.h"

#include <string>

namespace gliftc {

/// `(+ a (* b 2))`: fully parenthesised, for types and values.
std::string print(ast::ExprId expr, const ast::Tree& tree, const Names& names);

/// One declaration, field, item or statement per line, indented by its depth.
std::string print(const ast::Module& module, const ast::Tree& tree, const Names& names);

}  // namespace gliftc
