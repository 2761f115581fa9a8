// What a kernel reads of structures, itself and by what it calls: functions, translators, views.
#pragma once

#include "ir/ir.h"

#include <functional>

namespace gliftc::ir {

/// Visits the memories that are read, as places of their structures (chain.h, root_of), with the span of the access in
/// the kernel's body. Reads of coherent memory by what declares it as coherent are left out.
void for_each_read(const Program& program, const Kernel& kernel, const std::function<void(const Place&, Span)>& visit);

}  // namespace gliftc::ir
