// Whether a body mentions a local.
#pragma once

#include "ir/walk.h"

namespace gliftc::cpp {

inline bool mentions(const ir::Program& program, const std::vector<ir::StmtId>& body, ir::LocalId local) {
    bool found = false;
    ir::for_each_expression(program, body, [&](ir::ExprId id) { found |= program.exprs[id].local == local; });
    return found;
}

/// "[[maybe_unused]] " before a parameter that the body does not mention.
inline const char* unused_mark(const ir::Program& program, const std::vector<ir::StmtId>& body, ir::LocalId local) {
    return mentions(program, body, local) ? "" : "[[maybe_unused]] ";
}

}  // namespace gliftc::cpp
