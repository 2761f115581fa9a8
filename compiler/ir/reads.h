// The memories that a kernel reads, itself and through the functions, translators and views that it uses.
#pragma once

#include "ir/ir.h"

#include <functional>

namespace gliftc::ir {

/// Calls `visit` for each memory that is read: with the place of the structure that has the memory (root_of() of
/// chain.h), and the span of the access in the kernel's body. Left out are reads of memory that the kernel or function
/// that reads it declares coherent, and reads of the kernel's arguments that are values on the device.
void for_each_read(const Program& program, const Kernel& kernel, const std::function<void(const Place&, Span)>& visit);

}  // namespace gliftc::ir
