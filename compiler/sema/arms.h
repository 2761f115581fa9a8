// Pipelines: `if` and loops whose condition is a value on the device, which the host does not know. The host records
// both branches of such an `if`, its arms; the passes of the arm that is not taken are dispatched over nothing. Also
// assignments to variables, which lie on the device where such a condition or a value on the device decides what they
// hold.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// `if c { … } else { … }` where c lies on the device: emits StmtOp::arms.
void check_arms(Body&, const ast::Stmt&, ir::ExprId condition);
/// Checks c and the body of `for i in a..b while c { … }`, and emits both into the loop. If c lies on the device,
/// `before` gets the declaration of a variable on the device, which says whether the loop goes on.
void check_rounds(Body&, const ast::Stmt&, std::vector<ir::StmtId>& before);

/// Checks and emits `target = value;`, `target += value;` and the like for a variable of a pipeline. Where this shows
/// that the variable must lie on the device, its declaration is added to Body::device_variables instead, and the
/// pipeline is then checked again (check_pipeline_body).
void check_variable(Body&, const ast::Stmt&, ir::ExprId target);
/// Records how many arms are around the declaration of the variable (Body::depths).
void declare_variable(Body&, ir::LocalId);
/// Whether an earlier check of this pipeline found that the variable declared at `name` lies on the device.
bool lies_on_device_later(const Body&, Span name);
/// Whether the variable is declared in the innermost arm around the code being checked, not outside of it.
bool is_of_innermost_arm(const Body&, ir::LocalId);
/// The initial value of a variable, brought to the device where an assignment needs the variable there.
ir::ExprId as_declared(Body&, ir::ExprId value, Span name);

/// Whether the code being checked is in an arm, which must not contain `what`; reports it with the remedy.
bool is_refused_in_arm(Body&, std::string_view what, Span, std::string remedy);
/// Records that the pipeline cannot be called in an arm, since at `span` it waits for the device, changes host state or
/// gives a member other memory, or calls a pipeline that does.
void needs_host(Body&, Span);

}  // namespace gliftc::sema
