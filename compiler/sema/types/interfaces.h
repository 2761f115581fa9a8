// Interfaces as constraints: functions that must exist for a type.
#pragma once

#include "sema/types/meta.h"

namespace gliftc::sema {

/// `interface I<T: type> { fn f(a: Self, b: T) -> T; }`: a type satisfies the constraint `I<uint>` if functions with
/// exactly these types can be called from the module of `env`: visible there, or found by argument-dependent lookup. If
/// not, `why` names a missing one, or says that the check depends on itself. True after an error in the constraint,
/// which has been reported.
bool satisfies_interface(Context&, const Env&, ast::DeclId interface, const ast::Expr& constraint, ir::TypeId,
                         std::string& why);

}  // namespace gliftc::sema
