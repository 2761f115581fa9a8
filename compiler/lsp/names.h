// What a name in a document denotes: from the index that sema made, or, in code that sema did not check, from the
// scopes of the syntax tree.
#pragma once

#include "lsp/analysis.h"

#include <optional>
#include <vector>

namespace gliftc::lsp {

/// The token that contains the offset or, if there is a name that ends there, that one. Null if there is neither.
const Token* token_at(const Analysis& analysis, std::size_t offset);

/// Whether the token is a name that programs choose: an identifier, also one that is a word of the language elsewhere.
bool is_name(const Token& token);

/// The places of the declarations that the token denotes: of a name, of the module in a `use`. Several for overloads
/// among which no call chooses. Empty for built-in names, and for others if it is not known.
std::vector<Span> declarations_of(const Analysis& analysis, const Token& token);

/// The entities that the name may mean at the offset, by scopes: the innermost declaration, or all overloads in the
/// module and its imports.
std::vector<const Entity*> visible_by_name(const Analysis& analysis, std::size_t offset, std::string_view name);

/// The entities that are parts of another one: its parameters, fields, items.
std::vector<const Entity*> parts_of(const Analysis& analysis, const Entity& whole);

/// All entities whose plain names mean something at the offset, inner ones first; also public ones of imports.
std::vector<const Entity*> visible_at(const Analysis& analysis, std::size_t offset);

/// The type that sema gave to a declared name; the absent type if it gave none.
ir::TypeId type_of_declared(const Analysis& analysis, Span name);

/// The type of what ends with the token: of `a.b` at its `b`. Absent if sema gave it none.
std::optional<sema::TypedSpan> type_at(const Analysis& analysis, const Token& token);

}  // namespace gliftc::lsp
