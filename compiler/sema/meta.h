// Compile-time meanings: names in scope, types as written, generic arguments, constraints.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// The declarations that `name` means in a module, its own before those it imports. Reports ambiguity; empty if
/// unknown.
std::vector<ast::DeclId> find_declarations(Context&, std::uint32_t module, ast::Identifier name);

/// What a name means in an instance of a module: generic argument, declaration, built-in type. kind none if unknown.
Meta find_meta(Context&, const Env&, ast::Identifier name);

/// What `structure Field = …` means, with its generic arguments bound. A structure learns that it is called so.
Meta meta_of_alias(Context&, ast::DeclId, const Env&, Span use);

/// What a type expression means; reports and gives none if it means nothing.
Meta meta_of(Context&, const Env&, ast::ExprId);

/// The concrete type that an expression names; reports otherwise and gives the error type.
ir::TypeId type_of(Context&, const Env&, ast::ExprId);

/// The value of a compile-time expression of the wanted type (or its own, if wanted is absent); reports otherwise.
std::optional<ir::Value> constant_of(Context&, const Env&, ast::ExprId, ir::TypeId wanted = {});

/// The checked value of a `const` declaration.
ir::ExprId constant_declaration(Context&, ast::DeclId);

/// A whole number written or computed at compile time: array sizes, group sizes, radii.
std::optional<std::uint32_t> count_of(Context&, const Env&, ast::ExprId);

/// Names near to `name` that are visible in a module, for did-you-mean.
std::string suggestion_for(Context&, const Env&, std::string_view name, const std::vector<std::string_view>& more = {});
void report_unknown(Context&, const Env&, ast::Identifier name, const std::vector<std::string_view>& more = {});

/// Text of a generic argument: 4, float, uint2(8, 8).
std::string to_text(const Context&, const Meta&);
/// The same with the modules of all that it names.
std::string to_qualified_text(const Context&, const Meta&);
bool same(const Meta&, const Meta&);

}  // namespace gliftc::sema
