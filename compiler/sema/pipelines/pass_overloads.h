// Overload resolution of kernels and pipelines.
#pragma once

#include "sema/bodies/body.h"
#include "sema/types/generics.h"

namespace gliftc::sema {

/// What overload resolution looks at in an argument.
struct PassArgument {
    ast::ExprId written;
    ir::TypeId type;            ///< of a value: its type, without TypeKind::device
    ir::StructureId structure;  ///< of a structure or slice: the instance
    bool waits = false;  ///< it is made of literals, `none` or a braced list: it takes the parameter's type and is
                         ///< checked once that is known
};

/// The best of the overloads that take the arguments; reports if there is none, or the call is ambiguous. A single
/// overload is returned unchecked.
std::optional<ast::DeclId> choose_pass(Body&, const std::vector<ast::DeclId>& overloads,
                                       const std::vector<ast::ExprId>& generics,
                                       const std::vector<PassArgument>& arguments, const ast::Expr& call,
                                       const Operand* owner);

/// The index of the kernel's `at` parameter if it has exactly one: its argument may be omitted if another parameter
/// gives the range.
std::optional<std::size_t> only_address(const std::vector<ast::Param>&);
/// Infers generic arguments from the call's arguments.
void infer_arguments(Body&, Arguments&, const std::vector<ast::Param>&, const std::vector<PassArgument>&);

}  // namespace gliftc::sema
