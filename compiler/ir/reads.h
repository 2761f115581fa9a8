// The memories that a kernel reads, itself and through the functions, translators and views that it uses.
#pragma once

#include "ir/ir.h"

#include <functional>

namespace gliftc::ir {

/// Visits the memories that are read: the place of the structure that has each (chain.h, root_of), with the span of the
/// access in the kernel's body. Left out are reads of memory that the kernel or function itself declares coherent, and
/// of the kernel's arguments that are values on the device.
void for_each_read(const Program& program, const Kernel& kernel, const std::function<void(const Place&, Span)>& visit);

}  // namespace gliftc::ir
