// Which kernel or pipeline a call means.
#pragma once

#include "sema/body.h"
#include "sema/generics.h"

namespace gliftc::sema {

/// An argument, as far as overloads are told apart by it.
struct PassArgument {
    ast::ExprId written;
    ir::TypeId type;  ///< of a value, wherever it lies
    std::optional<std::uint32_t> structure;
    bool waits = false;  ///< a literal, which takes the parameter's type
};

/// The best of the overloads that take the arguments; reports if there is none, or the call is ambiguous.
std::optional<ast::DeclId> choose_pass(Body&, const std::vector<ast::DeclId>& overloads,
                                       const std::vector<ast::ExprId>& generics,
                                       const std::vector<PassArgument>& arguments, const ast::Expr& call,
                                       const Operand* owner);

/// The kernel's `at` parameter if it has exactly one: its argument may be omitted if another parameter gives the range.
std::optional<std::size_t> only_address(const std::vector<ast::Param>&);
/// Binds what the arguments say of generic parameters.
void infer_arguments(Body&, Arguments&, const std::vector<ast::Param>&, const std::vector<PassArgument>&);

}  // namespace gliftc::sema
