// Checks that a program or pass is well formed: the invariants between stages. A violation is a bug of the compiler.
#pragma once

#include "ir/pass.h"

#include <string>
#include <vector>

namespace gliftc::ir {

/// Errors in the lowered pass, one a line; empty if it is valid.
std::vector<std::string> validate(const Program& program, const Pass& pass);

/// The same for statements during lowering, when uniform expressions need not be parameters yet. `declared` are locals
/// that the body may use without declaring them: a function's parameters.
std::vector<std::string> validate(const Program& program, const Pass& pass, const std::vector<StmtId>& body,
                                  const std::vector<LocalId>& declared);

}  // namespace gliftc::ir
