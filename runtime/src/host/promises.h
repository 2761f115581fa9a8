// Promises of kernels (@disjoint) on the host device, where tests look for broken ones.
#pragma once

#include <glift/kernel.h>
#include <glift/memory.h>

#include <span>

namespace glift::detail {

/// Whether the kernel promises that memory which the call binds twice is not read where it is written.
bool relies_on_promise(const Kernel& kernel, std::span<const Memory> memories);

/// Throws aliased_memory if some invocation is found to read an element that the call writes, through a parameter that
/// promises not to. To find out, the call is run several times, on copies of all that it writes. A read is not found if
/// it changes no result; and where results depend on the order of invocations, no read is found.
void check_promises(const Kernel& kernel, const Form& form, std::span<const Memory> memories, const HostCall& call);

}  // namespace glift::detail
