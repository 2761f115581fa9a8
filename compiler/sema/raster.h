// Draws: what a raster's declaration and its two parts may say.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// A parameter of the pattern `target`, after what all parameters are checked for.
void add_target(Body&, const ast::Param&, const ir::KernelParam&, std::uint32_t index);

/// Whether parameters of this pattern are for passes of this kind; reports where not.
bool is_at_home(Context&, const ast::Param&, ir::Pattern, bool in_raster);

/// States, varyings, the iteration and both parts. The parameters are in scope.
void check_raster(Body&, const ast::Kernel& written);

/// Whether the structure's elements are texels of depth.
bool has_depth_format(const ir::Structure&);

/// Reports what every path through a part must have assigned, and what is assigned twice.
void check_assigned(Context&, const ir::Kernel&);

/// The value of a target: a local of the fragment part.
ir::LocalId target_value(const ir::Kernel&, std::uint32_t param);

/// `colour = value;`
void assign_target(Body&, const ast::Stmt&, const Symbol&, ast::ExprId root);

/// The part in which the current element of such a parameter has a meaning.
ir::Part part_of(ir::Pattern);

/// `discard;`
void check_discard(Body&, const ast::Stmt&);

/// Built-in functions of the two parts. Absent: it is none of them.
std::optional<Operand> call_in_raster(Body&, std::string_view name, const ast::Expr& call);

/// Reports that something belongs to another part, or to no kernel; true where it is in the right one.
bool is_in_part(Body&, ir::Part wanted, std::string_view name, Span);

}  // namespace gliftc::sema
