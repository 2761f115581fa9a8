// Memory that is a structure: made where it is declared, or one that has a name.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// Whether the structure has a memory already, which is reported: it has one.
bool has_memory(Body&, std::uint32_t structure, const ast::Item& another);

/// Whether what `memory name = …` says is a structure, made there or elsewhere, rather than a buffer or an image.
bool is_structure_memory(Body&, ast::ExprId);

void add_base(Body&, std::uint32_t structure, const ast::Item&);

/// Declares the memory's name, where it is a structure and has another name, too.
void declare_base(Body&, std::uint32_t structure);

/// The domain of the memory, which is a structure.
ir::ExprId domain_of_base(Body&, std::uint32_t structure);

/// Whether no translator reads the memory that it leads to; reported where one does.
bool check_own_memory(Context&, std::uint32_t structure);

}  // namespace gliftc::sema
