// Constructors of structures.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// The parameters of the structure's constructor; null: the declaration is something else.
const std::vector<ast::Param>* constructor_of(const ast::Decl&);

/// The items in the body of the declaration of a structure.
const std::vector<ast::Item>& items_of(const ast::Decl&);

/// The items of an instance: of those inside an `if`, the ones that its condition selects for the instance's arguments.
std::vector<const ast::Item*> items_of(Context&, ir::StructureId structure);

/// What `Name<…>` means in the call `Name<…>(arguments)`: a Meta of kind `type` if the call constructs a value or a
/// structure. Generic arguments of a structure that are not written are inferred from those arguments
/// of the call that are structures, given by a name or a path of members. A Meta of kind `none` after an error.
Meta constructed_type(Body&, const ast::Expr& call);

}  // namespace gliftc::sema
