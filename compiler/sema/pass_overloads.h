// Overload resolution of kernels and pipelines.
#pragma once

#include "sema/body.h"
#include "sema/generics.h"

namespace gliftc::sema {

/// What overload resolution looks at in an argument.
struct PassArgument {
    ast::ExprId written;
    ir::TypeId type;                         ///< a value: its type; for one on the device, without `device`
    std::optional<std::uint32_t> structure;  ///< a structure or slice: the instance
    bool waits = false;  ///< a literal, checked only once the parameter's type is known, which it takes
};

/// The best of the overloads that take the arguments; reports if there is none, or the call is ambiguous.
std::optional<ast::DeclId> choose_pass(Body&, const std::vector<ast::DeclId>& overloads,
                                       const std::vector<ast::ExprId>& generics,
                                       const std::vector<PassArgument>& arguments, const ast::Expr& call,
                                       const Operand* owner);

/// The kernel's `at` parameter if it has exactly one: its argument may be omitted if another parameter gives the range.
std::optional<std::size_t> only_address(const std::vector<ast::Param>&);
/// Infers generic arguments from the call's arguments.
void infer_arguments(Body&, Arguments&, const std::vector<ast::Param>&, const std::vector<PassArgument>&);

}  // namespace gliftc::sema
