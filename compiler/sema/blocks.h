// Blocks: boxes of one size in a structure's domain. Where a structure declares blocks, kernels over it visit their
// elements and no others, except the kernels that find_space() leaves out. Also which parameter's blocks a kernel
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

/// Checks the declarations and sets Structure::blocks. To be called once Structure::domain_type is set: block() and
/// block_size() return addresses of that type.
void add_blocks(Context&, const Env&, std::uint32_t structure, const BlockItems&);

/// A call of `s.blocks()`, `s.block(i)` or `s.block_size()`; a structure without blocks, its own or those of its memory
/// (ir::blocks_of), has one: its domain. Absent if the method has another name.
std::optional<Operand> call_of_blocks(Body&, const Operand& self, ast::Identifier method, const ast::Expr& call);

/// Finds the blocks that a kernel visits. The parameters that decide are those written by `each`; if there are none,
/// those that are `at`; else those read by `each` or `near`. If all of them have blocks (ir::blocks_of), Kernel::space
/// is the first of them and Kernel::same_space the others; one ir::Structure must declare the blocks of all (else an
/// error). Kernel::space stays empty if one of them has no blocks, for draws, for kernels with a group, and for those
/// whose invocations take several elements. Where the host does not know how many blocks there are, also makes the
/// pipeline that counts them (Blocks::counter).
void find_space(Context&, ir::Kernel&);

/// Makes a pipeline over a structure that declares blocks, which gives their number as a value on the device, for the
/// dispatch that follows the call. Its index in Program::pipelines; absent after an error.
std::optional<std::uint32_t> counter_of_blocks(Context&, std::uint32_t structure, Span use);

}  // namespace gliftc::sema
