// Interfaces as constraints: the functions that a type must come with.
#pragma once

#include "sema/meta.h"

namespace gliftc::sema {

/// `interface I<T: type> { fn f(a: Self, b: T) -> T; }`: a type satisfies `I<uint>`, written as `constraint`, if such
/// functions can be called from the module of `env`: visible there, or where the types of their arguments are declared.
/// `why` says which is missing.
bool satisfies_interface(Context&, const Env&, ast::DeclId interface, const ast::Expr& constraint, ir::TypeId,
                         std::string& why);

}  // namespace gliftc::sema
