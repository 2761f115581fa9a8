// The updates of a kernel that threads of the host device combine (glift/host/updates.h).
#pragma once

#include "ir/pass.h"

#include <map>
#include <vector>

namespace gliftc::host {

/// The class in glift/host/updates.h.
const char* operation_name(ir::Combine combine);

/// The operations by which the pass updates bindings, for those whose updates a thread combines.
std::map<std::uint32_t, ir::Combine> combined_bindings(const ir::Program& program, const ir::Pass& pass);

/// The row updates of a body, one of those with the same memory and index.
std::vector<ir::Stmt> row_updates(const ir::Program& program, const std::vector<ir::StmtId>& body);

}  // namespace gliftc::host
