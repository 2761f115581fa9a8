// Errors that a kernel reported through its StatusRecord, and those about where a call may stand.
#pragma once

#include <glift/pass.h>

namespace glift::detail {

/// What to do about loops that a device cuts off.
inline constexpr const char* loop_remedy =
    "split the work over more invocations or dispatches, or run on another device "
    "(GLIFT_DEVICE=gpu or GLIFT_DEVICE=host)";

/// Throws loop_limit or out_of_range if the record says so.
void throw_report(const Kernel& kernel, const StatusRecord& record);

[[noreturn]] void throw_not_in_recording(const char* call);
[[noreturn]] void throw_missing_form(const Kernel& kernel, const char* form, const char* device);

}  // namespace glift::detail
