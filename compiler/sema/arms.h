// Control flow on conditions that live on the device, and variables that do.
#pragma once

#include "sema/body.h"

namespace gliftc::sema {

/// `if c { … } else { … }` where c lives on the device.
void check_arms(Body&, const ast::Stmt&, ir::ExprId condition);
/// The condition and the statements of `for i in a..b while c { … }`, in the loop; `before`: what stands before it.
void check_rounds(Body&, const ast::Stmt&, std::vector<ir::StmtId>& before);

/// `target = value;` and the like for a variable of a pipeline. One that turns out to lie on the device is noted: the
/// pipeline is then checked again (check_pipeline_body).
void check_variable(Body&, const ast::Stmt&, ir::ExprId target);
void declare_variable(Body&, ir::LocalId);
bool lies_on_device_later(const Body&, Span name);

/// Reports what an arm must not contain, with the remedy.
bool is_refused_in_arm(Body&, std::string_view what, Span, std::string remedy);
/// Notes that the pipeline can be called in no arm: it waits, or changes what the host knows.
void needs_host(Body&, Span);

}  // namespace gliftc::sema
