// Closures: `|a, b| a * b`, arguments of calls.
//
// The type of a closure is a struct of the values that it captures. It has no function until a constraint asks whether
// it satisfies an interface of one function: then its call becomes that function, with the parameter types and the
// result that the interface says (ClosureType::Call). Argument-dependent lookup finds it under the interface's name.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// The closure as a value. Reports a captured name that is not a value.
Operand check_closure(Body&, ast::ExprId);

/// The closure type that the type is; null if it is another one.
const ClosureType* closure_of(const Context&, ir::TypeId);

/// Makes the closure's call the function of this name; `types` are those of its parameters, the closure first, and of
/// its result. False if the closure does not take these parameters; `why` is the reason.
bool give_call(Context&, ir::TypeId closure, Name function, const std::vector<ir::TypeId>& types, std::string& why);

/// The type of the closure's result for parameters of these types; absent if the body does not allow them, or is a
/// block. Reports nothing.
ir::TypeId result_of_call(Context&, ir::TypeId closure, const std::vector<ir::TypeId>& params);

/// ir::Function::key of a ClosureType::Call::decl.
std::string key_of_call(const Context&, ast::DeclId call);

/// Declares the captured values in the body of the closure's call, whose first parameter is `closure`.
void declare_captured(Body&, ir::StructId type, ir::LocalId closure);

/// Whether a closure is found where another type is wanted; reports it then.
bool report_closure(Context&, ir::TypeId found, ir::TypeId wanted, Span);

}  // namespace gliftc::sema
