// Blocks: what of a structure's domain is there, and which blocks a kernel visits.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// What a structure declares of its blocks: the declarations of those names, or nothing.
struct BlockItems {
    ast::DeclId blocks, block, block_size;

    /// Takes the declaration if its name is one of these.
    void note(const Context&, ast::DeclId);
};

/// Checks the declarations. The structure has its domain type and extent.
void add_blocks(Context&, const Env&, std::uint32_t structure, const BlockItems&);

/// `s.blocks()`, `s.block(i)`, `s.block_size()`; absent: another name.
std::optional<Operand> call_of_blocks(Body&, const Operand& self, ast::Identifier method, const ast::Expr& call);

/// Sets Kernel::space: what is written by `each` says what is visited; if nothing is, then `at`; else what is read by
/// `each` and `near`.
void find_space(Context&, ir::Kernel&);

}  // namespace gliftc::sema
