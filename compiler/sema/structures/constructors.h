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

/// The default of an argument of a constructor, over the arguments before it, which `earlier` has in scope; absent if
/// it has none. A constant is folded.
ir::ExprId default_of(Body& earlier, const ast::Param&, ir::TypeId);

/// Whether the call gives as many arguments as the constructor takes; reports if not. The last ones may be left out if
/// they have defaults.
bool has_argument_count(Context&, ir::StructureId, const ast::Expr& call);

/// The defaults of the value arguments that a call leaves out, where it gives `values`. These may then stand in several
/// places.
ir::Operands omitted_arguments(Body&, ir::StructureId, std::vector<ir::ExprId> values);

}  // namespace gliftc::sema
