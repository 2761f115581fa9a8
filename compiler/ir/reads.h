// The memories that a kernel's body reads, directly and through the functions, translators and views that it uses.
#pragma once

#include "ir/ir.h"

#include <functional>

namespace gliftc::ir {

/// Calls `visit` for each memory that an expression or write of the kernel (of a draw: both parts) reads:
/// with the place of the structure that has the memory (root_of() of chain.h), and the span of the access in the body.
/// Left out are reads of memory that the kernel or function that reads it declares coherent, and reads of the kernel's
/// arguments that are values on the device.
void for_each_read(const Program& program, const Kernel& kernel, const std::function<void(const Place&, Span)>& visit);

}  // namespace gliftc::ir
