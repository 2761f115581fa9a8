// Checks that a program or pass is well formed: what a stage guarantees the next. A violation is a fault of the
// compiler.
#pragma once

#include "ir/pass.h"

#include <string>
#include <vector>

namespace gliftc::ir {

/// What is wrong with the lowered pass, a line each; empty: nothing.
std::vector<std::string> validate(const Program& program, const Pass& pass);

/// The same of statements in the middle of lowering, where uniform leaves are allowed; `declared` are a function's
/// parameters.
std::vector<std::string> validate(const Program& program, const Pass& pass, const std::vector<StmtId>& body,
                                  const std::vector<LocalId>& declared);

}  // namespace gliftc::ir
