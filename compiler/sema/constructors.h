// Constructors of structures, views and adaptors.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// The parameters of the structure's, view's or adaptor's constructor; null: the declaration is something else.
const std::vector<ast::Param>* constructor_of(const ast::Decl&);

/// What the structure, view or adaptor is declared to be made of.
const std::vector<ast::Item>& items_of(const ast::Decl&);

/// What `Name<…>(arguments)` makes. Generic arguments that are not written are inferred from the structures that it is
/// given.
Meta constructed_type(Body&, const ast::Expr& call);

}  // namespace gliftc::sema
