// Blocks: equal boxes that a structure declares, outside which its domain has no elements; and which blocks a kernel
// visits.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// The functions of these names that a structure declares; absent where it does not.
struct BlockItems {
    ast::DeclId blocks, block, block_size;

    /// Keeps the declaration if it has one of these names.
    void note(const Context&, ast::DeclId);
};

/// Checks the declarations and sets Structure::blocks. To be called once the structure has its domain.
void add_blocks(Context&, const Env&, std::uint32_t structure, const BlockItems&);

/// A call of `s.blocks()`, `s.block(i)` or `s.block_size()`; absent if the method has another name.
std::optional<Operand> call_of_blocks(Body&, const Operand& self, ast::Identifier method, const ast::Expr& call);

/// Sets Kernel::space, the parameter whose blocks the kernel visits: the first that is written by `each`; if there is
/// none, by `at`; else the first that is read by `each` or `near`. It stays empty if one of these parameters has no
/// blocks.
void find_space(Context&, ir::Kernel&);

/// A pipeline (an index in Program::pipelines) over a structure that declares blocks, which gives their number as a
/// value of the device, for the dispatch that follows the call.
std::optional<std::uint32_t> counter_of_blocks(Context&, std::uint32_t structure, Span use);

}  // namespace gliftc::sema
