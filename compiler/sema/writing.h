// What functions and kernels write: how patterns are declared, what a call may do, what a kernel's calls do together.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// Of those that write: scatter, coherent, calls.
ir::Pattern written_pattern(ast::Pattern);

/// Checks that the pattern allows the direction, and sets it.
void check_direction(Context&, const ast::Param&, ir::KernelParam&);

/// The operation that `scatter<…, op>` names; reports one that cannot combine the structure's elements.
ir::Combine check_combine(Context&, ast::ExprId operation, std::uint32_t structure);

/// Elements that workgroups share must be in a buffer.
void check_coherent(Context&, ast::Identifier name, std::uint32_t structure);

/// Reports a view, which has no elements to write.
void check_stored(Context&, Span, std::uint32_t structure);

/// A parameter of a function with a pattern that writes: its symbol, and what the function thereby does.
void declare_writing(Body&, const ast::Param&, ir::KernelParam made, ir::Place, ir::Function&);

/// `with …`: which members the function writes, and how.
void declare_with(Body&, const ast::Function&, ir::Function&);

/// Whether an argument is accessed as the function's parameter says.
bool fits_writing(Body&, const Env&, const ast::Param&, const Operand& argument);

/// What the call of a function does is done by the function or kernel that calls it. `given`: its structures, of which
/// the first is its container where `is_method`. False after an error.
bool add_effects(Body&, ir::FunctionId, const std::vector<Operand>& given, bool is_method, Span);

/// Reports accesses of a kernel to one memory that do not go together.
void check_effects(Context&, const ir::Kernel&);

}  // namespace gliftc::sema
