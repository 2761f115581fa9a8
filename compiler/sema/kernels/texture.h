// Methods of structures that do what texture units of devices do: `sample`, `gather`, `compare`.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// A call of one of these methods, of a structure that does not declare it itself; none: the name is another one.
std::optional<Operand> call_of_texture(Body& body, std::string_view name, const Operand& self,
                                       const std::vector<ast::ExprId>& arguments, const ast::Expr& call);

}  // namespace gliftc::sema
