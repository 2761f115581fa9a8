// Draws (`raster`): kernels of a vertex and a fragment part with the rasteriser between them. Checks of the declaration
// and both parts.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// Checks what is special to a parameter with pattern `target`, after the checks that all parameters get, and adds the
/// target to the draw.
void add_target(Body&, const ast::Param&, const ir::KernelParam&, std::uint32_t index);

/// Whether a draw (`in_raster`), or a kernel that does not draw, may have parameters of this pattern; reports one that
/// is not allowed.
bool is_at_home(Context&, const ast::Param&, ir::Pattern, bool in_raster);

/// Checks `cull` and `draw`, the varyings, the address types of corners, instances and pixels, and both parts. The
/// parameters must be in scope.
void check_raster(Body&, const ast::Kernel& written);

/// Reports what some path through a part leaves unassigned: in the vertex part the place of the corner (its clip
/// coordinates), varyings and clip distances; in the fragment part colour targets, except on paths that discard. Also
/// reports a corner that is placed twice on a path, or in a loop.
void check_assigned(Context&, const ir::Kernel&);

/// The local of the fragment part that holds the value for a target; absent if the target had an error.
ir::LocalId target_value(const ir::Kernel&, std::uint32_t param);

/// Checks and emits an assignment to a target, `colour = value;` or `depth = value;`.
void assign_target(Body&, const ast::Stmt&, const Symbol&, ast::ExprId root);

/// The part in which parameters of this pattern can be used: vertex for corners and instances, fragment for pixels and
/// targets; whole: both.
ir::Part part_of(ir::Pattern);

/// Checks and emits `discard;`.
void check_discard(Body&, const ast::Stmt&);

/// A call of place, clip_distance, window, front_facing or, in a part of a draw, position. Absent for a call of any
/// other name, and of position elsewhere.
std::optional<Operand> call_in_raster(Body&, std::string_view name, const ast::Expr& call);

/// Whether the code being checked is in the wanted part (`whole`: in either, or not in a draw); reports the use of
/// `name` elsewhere.
bool is_in_part(Body&, ir::Part wanted, std::string_view name, Span);

}  // namespace gliftc::sema
