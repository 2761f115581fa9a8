// Compile-time meanings of names, type expressions, generic arguments and constraints.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// The declarations of `name` in a module: its own, else the public ones of its imports. Reports ambiguity. If imports
/// declare the name, but all without `pub`, reports that and gives these declarations; but if the language itself has a
/// type, texel format, memory shape or constraint of that name, reports nothing and gives none.
std::vector<ast::DeclId> find_declarations(Context&, ir::ModuleId module, ast::Identifier name);

/// The meaning of a name in an environment: bound there, `Self`, declared in its module or imports, built into the
/// language, or the name of an imported module or its last part (`array` of `std.array`). Kind none if unknown.
Meta find_meta(Context&, const Env&, ast::Identifier name);

/// The imported module that an expression such as `std.array` names by its whole name. Absent if it names none, or if
/// the first of its words means something else in the environment.
ir::ModuleId module_by_whole_name(Context&, const Env&, ast::ExprId);

/// The meaning of `name` behind a module's name: what that module declares itself, and as public if the module is not
/// that of `env`. Reports others; kind none if the module does not declare the name.
Meta find_in_module(Context&, const Env& env, ir::ModuleId module, ast::Identifier name);

/// The meaning of an alias, `structure Field = …`, whose generic arguments `env` binds. If the alias has no generic
/// parameters and denotes a structure, its name is added to Structure::aliases of that structure.
Meta meta_of_alias(Context&, ast::DeclId, const Env&, Span use);

/// The meaning of an expression where a type, translator or constant is wanted; reports an invalid one and returns a
/// Meta of kind none.
Meta meta_of(Context&, const Env&, ast::ExprId);

/// The type of a texel's value: float4 for rgba8.
ir::TypeId value_of_format(ir::Types&, ir::Format);

/// The meaning where a type is wanted: a texel format stands for the type of its values, anything else is unchanged.
Meta as_type(Context&, const Meta&);

/// The concrete type that an expression denotes; else reports and returns the error type.
ir::TypeId type_of(Context&, const Env&, ast::ExprId);
/// The type of a parameter, which must be written.
ir::TypeId type_of(Context&, const Env&, const ast::Param&);

/// The value of a compile-time expression of type `wanted`. If `wanted` is absent, the expression has its own type; one
/// made of literals without suffix is then a uint, so that 1.5 is an error. Absent after an error, also if the
/// expression is not known at compile time.
std::optional<ir::Value> constant_of(Context&, const Env&, ast::ExprId, ir::TypeId wanted = {});

/// The checked value of a `const` declaration; absent after an error.
ir::ExprId constant_declaration(Context&, ast::DeclId);

/// The value of a compile-time int or uint from 0 to 2^32 - 1, such as an array size or a radius; reports any other
/// value.
std::optional<std::uint32_t> count_of(Context&, const Env&, ast::ExprId);

/// Text of a generic argument: 4, float, uint2(8, 8).
std::string to_text(const Context&, const Meta&);
/// As to_text(), with module-qualified names.
std::string to_qualified_text(const Context&, const Meta&);
bool same(const Meta&, const Meta&);

}  // namespace gliftc::sema
