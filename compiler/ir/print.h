// A program, or its lowered passes, as text: for --dump and --dump-after, and for tests. Passes are read back by
// read.h.
#pragma once

#include "ir/pass.h"

#include <string>
#include <vector>

namespace gliftc::ir {

std::string print(const Program& program);
std::string print(const Program& program, const Lowered& lowered);
/// `facts` are conditions that are known to hold throughout the body.
std::string print(const Program& program, const Pass& pass, const std::vector<ExprId>& facts = {});

/// One function, expression or list of statements. The names of bindings and parameters are those of `pass`; without
/// a pass they are numbered.
std::string print(const Program& program, FunctionId function, const Pass* pass = nullptr);
std::string print(const Program& program, ExprId expr, const Pass* pass = nullptr);
std::string print(const Program& program, const std::vector<StmtId>& body, const Pass* pass = nullptr);

}  // namespace gliftc::ir
