// Structures whose memory is itself a structure, called the base: one that the declaration constructs, `memory name =
// Type(…);`, or one that is named there, `memory name = pool;` or `= pool.part;`.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// Whether the structure already has a memory; reports `another` then, since a structure has only one.
bool has_memory(Body&, ir::StructureId structure, const ast::Item& another);

/// Whether the expression in `memory name = …` has the form of a structure, constructed there or named, rather than of
/// a buffer or an image. add_base() checks that it is one.
bool is_structure_memory(Body&, ast::ExprId);

/// Sets the memory of the structure to the structure that the item names or constructs.
void add_base(Body&, ir::StructureId structure, const ast::Item&);

/// Brings the name of the base into scope. Does nothing if the structure has no base, or if the declaration constructs
/// the base: then it is a member of that name, which is in scope already.
void declare_base(Body&, ir::StructureId structure);

/// The domain of the base, as an expression over the structure whose memory it is.
ir::ExprId domain_of_base(Body&, ir::StructureId structure);

/// Whether no translator of the structure reads its base, a structure inside the base, or one that contains the base;
/// reports one that does.
bool check_own_memory(Context&, ir::StructureId structure);

}  // namespace gliftc::sema
