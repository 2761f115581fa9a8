// Checks that a lowered pass, or a body during lowering, is well formed. A violation is a bug of the compiler.
#pragma once

#include "ir/pass.h"

#include <string>
#include <vector>

namespace gliftc::ir {

/// The errors in the lowered pass; empty if it is valid.
std::vector<std::string> validate(const Program& program, const Pass& pass);

/// The errors in a body during lowering, when uniform expressions need not be parameters yet, and guarded loads are
/// allowed. `declared` are locals that the body may use without declaring them, such as a function's parameters.
std::vector<std::string> validate(const Program& program, const Pass& pass, const std::vector<StmtId>& body,
                                  const std::vector<LocalId>& declared);

}  // namespace gliftc::ir
