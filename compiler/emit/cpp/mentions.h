// Whether a body mentions a local.
#pragma once

#include "ir/walk.h"

namespace gliftc::cpp {

using ir::mentions;

/// What stands before a parameter: "[[maybe_unused]] " if the body does not mention it, else nothing.
inline const char* unused_mark(const ir::Program& program, const std::vector<ir::StmtId>& body, ir::LocalId local) {
    return mentions(program, body, local) ? "" : "[[maybe_unused]] ";
}

}  // namespace gliftc::cpp
