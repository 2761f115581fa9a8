// Pipelines: `if` and loops whose condition is a value on the device, which the host does not know. The host records
// both branches of such an `if`, and all rounds of such a loop. A branch, or the body of such a loop, is called an arm
// (Body::Arm); where its condition does not hold, its passes are dispatched with zero workgroups, except passes that
// compute a value without calling a function: these run in any case (emit/cpp/pipelines.cpp). A variable of a pipeline
// lies on the device if it is assigned in an arm but declared outside of it, or if it is given a value on the device.
#pragma once

#include "sema/bodies/body.h"

namespace gliftc::sema {

/// Checks `if c { … } else { … }`, where c lies on the device, and emits it as a statement StmtOp::arms.
void check_arms(Body&, const ast::Stmt&, ir::ExprId condition);
/// Checks c and the body of `for i in a..b while c { … }`, and emits both into the body of the loop. If c lies on the
/// device, adds to `before`, the statements that precede the loop, the declaration of a variable on the device, which
/// says whether the loop goes on.
void check_rounds(Body&, const ast::Stmt&, std::vector<ir::StmtId>& before);

/// Checks and emits `target = value;`, `target += value;` and the like for a variable of a pipeline. Where this shows
/// that the variable must lie on the device, its declaration is added to Body::device_variables instead, and the
/// pipeline is then checked again (check_pipeline_body). If the declaration is there already, the type of the variable
/// cannot lie on the device, which is reported unless there are errors already.
void check_variable(Body&, const ast::Stmt&, ir::ExprId target);
/// Records how many arms are around the declaration of the variable (Body::depths).
void declare_variable(Body&, ir::LocalId);
/// Whether a check of this pipeline, the current one or an earlier one, has found that the variable declared at `name`
/// must lie on the device.
bool lies_on_device_later(const Body&, Span name);
/// Whether the variable is declared in the innermost arm around the code being checked, not outside of it. True if no
/// arm is around the code.
bool is_of_innermost_arm(const Body&, ir::LocalId);
/// The initial value of the variable that is declared at `name`: `value`, computed on the device if an assignment needs
/// the variable there (lies_on_device_later()).
ir::ExprId as_declared(Body&, ir::ExprId value, Span name);

/// Whether the code being checked is in an arm, which must not contain `what`; reports it with the remedy.
bool is_refused_in_arm(Body&, std::string_view what, Span, std::string remedy);
/// Records where the pipeline waits for the device, changes host state or gives a member other memory, itself or in a
/// pipeline that it calls (Body::host_needed). Such a pipeline cannot be called in an arm. Only the first call has an
/// effect.
void needs_host(Body&, Span);

}  // namespace gliftc::sema
