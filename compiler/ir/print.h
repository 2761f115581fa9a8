// A program, or its lowered passes, as text: for --dump=ir and --dump=lower, and for tests. Not read back.
#pragma once

#include "ir/pass.h"

#include <string>
#include <vector>

namespace gliftc::ir {

std::string print(const Program& program);
std::string print(const Program& program, const Lowered& lowered);
std::string print(const Program& program, const Pass& pass);

/// One function, expression or list of statements; a pass gives the names of its bindings and parameters.
std::string print(const Program& program, FunctionId function, const Pass* pass = nullptr);
std::string print(const Program& program, ExprId expr, const Pass* pass = nullptr);
std::string print(const Program& program, const std::vector<StmtId>& body, const Pass* pass = nullptr);

}  // namespace gliftc::ir
