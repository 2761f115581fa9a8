// What functions and kernels write (their effects): declarations by patterns and `with`, effects of calls, and
// conflicts between the effects of one kernel, or between its effects and its reads.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// The pattern of the IR for scatter, coherent or calls.
ir::Pattern written_pattern(ast::Pattern);

/// Checks that the pattern allows the written direction, and sets it in the KernelParam.
void check_direction(Context&, const ast::Param&, ir::KernelParam&);

/// The operation named by `scatter<…, op>`; reports one that cannot combine the structure's elements.
ir::Combine check_combine(Context&, ast::ExprId operation, ir::StructureId structure);

/// Reports a structure for `coherent` whose elements are neither in a buffer nor in an image of r32i or r32ui:
/// workgroups can share no others.
void check_coherent(Context&, ast::Identifier name, ir::StructureId structure);

/// Reports a view, which has no elements to write.
void check_stored(Context&, Span, ir::StructureId structure);

/// Reports a written structure whose memory has the format d32: shaders cannot store depths.
void check_depth_written(Context&, ast::Identifier name, ir::StructureId structure);

/// Declares a parameter of a function with a pattern that writes, and adds the effect that this gives the function
/// (`calls` gives none).
void declare_writing(Body&, const ast::Param&, ir::KernelParam made, ir::Place, ir::Function&);

/// Reads the `with …` of a function, which says which members it writes, and how: sets Symbol::writing of each, and
/// adds the effects (`calls` gives none).
void declare_with(Body&, const ast::Function&, ir::Function&);

/// Whether the caller may access the argument by the pattern of the function's parameter; reports if not.
bool fits_writing(Body&, const Env&, const ast::Param&, const Operand& argument);

/// Adds the effects of the called function to those of the function or kernel that calls it, unless they are there
/// already. `given`: the structures passed, of which the first is the callee's container if `is_method`. False after an
/// error.
bool add_effects(Body&, ir::FunctionId, const std::vector<Operand>& given, bool is_method, Span);

/// Reports the first two functions called by a kernel that write one memory by different patterns or operations; if
/// there are none, the first read of a memory that the kernel also writes by scatter or through functions. Looks at
/// both parts of a draw.
void check_effects(Context&, const ir::Kernel&);

}  // namespace gliftc::sema
