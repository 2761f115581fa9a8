// Blocks: boxes of one size in a structure's domain. Where a structure declares blocks, kernels over it visit the
// elements of the blocks and no others, except the kernels that find_space() leaves out. find_space() also chooses the
// parameter whose blocks a kernel visits.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// The functions of these names that a structure declares. An absent id: it does not declare that function.
struct BlockItems {
    ast::DeclId blocks, block, block_size;

    /// Keeps the declaration if it has one of these names; reports a second one of the name.
    void note(Context&, ast::DeclId);
};

/// Checks the declarations, if there are any, and sets Structure::blocks. To be called once Structure::domain_type is
/// set: block() and block_size() return addresses of that type.
void add_blocks(Context&, const Env&, ir::StructureId structure, const BlockItems&);

/// A call of `s.blocks()`, `s.block(i)` or `s.block_size()`. If ir::blocks_of() finds no blocks for the structure,
/// its whole domain is one block. Absent if the method has another name.
std::optional<Operand> call_of_blocks(Body&, const Operand& self, ast::Identifier method, const ast::Expr& call);

/// Finds the blocks that a kernel visits. The parameters that decide are those written by `each`; if there are none,
/// those that are `at`; else those read by `each` or `near`. If all of them have blocks (ir::blocks_of), Kernel::space
/// is the first of them and Kernel::same_space the others; one ir::Structure must declare the blocks of all (else an
/// error). Kernel::space stays empty if one of them has no blocks, for draws, for kernels with a group, and for those
/// whose invocations take several elements. If the host does not know how many blocks Kernel::space has, also makes the
/// pipeline that counts them (Blocks::counter), unless it is made already.
void find_space(Context&, ir::Kernel&);

/// Makes a pipeline that takes a structure which declares blocks, and returns their number as a value on the device,
/// for the dispatch that follows the call. The value may exceed Blocks::bound, which the dispatch applies. Empty
/// after an error.
ir::PipelineId counter_of_blocks(Context&, ir::StructureId structure, Span use);

}  // namespace gliftc::sema
