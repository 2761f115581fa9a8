// The limit on the private memory of an invocation.
#pragma once

#include "diag/diagnostics.h"
#include "ir/pass.h"

namespace gliftc::layout {

/// The bytes that the variables of an invocation may take. The host device keeps them, and copies of some, on the stack
/// of a thread, which has 8 MiB on Linux. The limit leaves room for several arrays of the longest type, 512 KiB.
inline constexpr std::uint64_t private_limit = 2u << 20;

/// Reports each kernel whose variables take more than private_limit. Counts every declaration of a body and of the
/// functions that it calls, also those that are never live at the same time.
void check_private_memory(const ir::Program&, const ir::Lowered&, Diagnostics&);

}  // namespace gliftc::layout
