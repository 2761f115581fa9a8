// Runs passes over the bodies of a kernel.
#pragma once

#include "lower/context.h"

#include <string_view>
#include <vector>

namespace gliftc::lower {

/// Called after each pass: validates its result in development builds, writes it to the trace if --dump-after names
/// this pass, and notes whether lowering stops here (--stop-after). `what` names the bodies in the trace.
void finished(Context& cx, std::string_view pass, const std::vector<ir::Variant>& variants,
              const std::vector<ExprId>& facts, std::string_view what);
void finished(Context& cx, std::string_view pass, const std::vector<StmtId>& body, const std::vector<ExprId>& facts,
              std::string_view what);

/// Runs the body passes (passes.h) over a body. `facts` are conditions that hold throughout the body.
std::vector<StmtId> simplified(Context& cx, std::string_view what, std::vector<StmtId> body,
                               const std::vector<ExprId>& facts = {});

}  // namespace gliftc::lower
