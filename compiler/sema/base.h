// The memory of a structure where it is itself a structure, its base: one constructed in the declaration, or an
// existing one given by name.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// Whether the structure already has a memory, of which there is only one; reports `another` then.
bool has_memory(Body&, std::uint32_t structure, const ast::Item& another);

/// Whether the expression in `memory name = …` is a structure, constructed there or named, rather than a buffer or an
/// image.
bool is_structure_memory(Body&, ast::ExprId);

/// Sets the memory of the structure to the structure that the item names or constructs.
void add_base(Body&, std::uint32_t structure, const ast::Item&);

/// Brings the memory's name into scope. Nothing to do where it was constructed there: it is a member of that name.
void declare_base(Body&, std::uint32_t structure);

/// The domain of the base, as an expression over the structure.
ir::ExprId domain_of_base(Body&, std::uint32_t structure);

/// Whether no translator of the structure reads the base that it translates to; reports one that does.
bool check_own_memory(Context&, std::uint32_t structure);

}  // namespace gliftc::sema
