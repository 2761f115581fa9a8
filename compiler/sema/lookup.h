// Which functions a plain name means: those visible in a module, and those that come with the types of the arguments.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

/// What a name means in a module: its own declarations, else the public ones of its imports. `hidden` are those that
/// the imports keep to themselves, where there is nothing else.
struct Visible {
    std::vector<ast::DeclId> found, hidden;
};

/// Reports a name that several imports declare, unless all declare functions.
Visible look_up(Context&, std::uint32_t module, ast::Identifier name);

bool is_function(const Context&, const std::vector<ast::DeclId>&);
bool some_module_has_function(const Context&, Name);

/// Adds the functions of this name, public or not, that stand in the modules of the structs and enums among `types`:
/// who passes a type passes its functions.
void add_functions_of_types(Context&, Name, const std::vector<ir::TypeId>& types, std::vector<ast::DeclId>& functions);

}  // namespace gliftc::sema
