// Name lookup: functions visible in a module, and those found by argument-dependent lookup.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// The declarations of a name that a module can see: its own, else the public ones of its imports. `hidden` are the
/// private ones of the imports, for messages where there are no others.
struct Visible {
    std::vector<ast::DeclId> found, hidden;
};

/// The declarations of the name that the module can see. Reports a name that several imports declare as public, unless
/// all declare functions, or all declare kernels or pipelines.
Visible look_up(Context&, ir::ModuleId module, ast::Identifier name);

/// Reports a use of a declaration that is not public, in another module.
void report_private(Context&, ast::Identifier name, ast::DeclId declared);

/// Whether the declarations of one name are kernels or pipelines; false if there are none. Looks at the first one:
/// kernels and pipelines are overloaded only with each other, functions only with functions.
bool is_pass(const Context&, const std::vector<ast::DeclId>&);
bool is_function(const Context&, const std::vector<ast::DeclId>&);
/// Whether a module declares a function of this name, or a closure is one.
bool some_module_has_function(const Context&, Name);

/// Argument-dependent lookup: adds the functions of this name, public or not, of the modules that declare the structs
/// and enums among `types`, and the calls of the closures among them. Arrays and optionals count as their elements.
void add_functions_of_types(Context&, Name, const std::vector<ir::TypeId>& types, std::vector<ast::DeclId>& functions);

}  // namespace gliftc::sema
