// Errors that a kernel reported through its StatusRecord, and those about where a call may stand.
#pragma once

#include <glift/pass.h>

namespace glift::detail {

/// Throws loop_limit or out_of_range if the record says so.
void throw_report(const Kernel& kernel, const StatusRecord& record);

[[noreturn]] void throw_not_in_recording(const char* call);
[[noreturn]] void throw_missing_form(const Kernel& kernel, const char* form, const char* device);

}  // namespace glift::detail
