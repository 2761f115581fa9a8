// Errors that a kernel reported through its StatusRecord, and those about where a call may stand.
#pragma once

#include <glift/commands.h>
#include <glift/pass.h>

#include <string>
#include <vector>

namespace glift::detail {

/// What to do about loops that a device cuts off.
inline constexpr const char* loop_remedy =
    "split the work over more invocations or dispatches, or run on another device "
    "(GLIFT_DEVICE=gpu or GLIFT_DEVICE=host)";

/// What reports say of a kernel; in words of its own, since the kernel's library may be unloaded before the report is
/// read.
struct Reporter {
    explicit Reporter(const Kernel& kernel);

    std::string kernel;  ///< as errors name it
    std::vector<std::string> bindings;
    std::vector<std::string> files;  ///< by StatusRecord::file
};

/// Throws loop_limit or out_of_range if the record says so.
void throw_report(const Reporter& reporter, const StatusRecord& record);

/// For commands that came after what they belong to was finished.
[[noreturn]] void throw_closed(std::string where);
[[noreturn]] void throw_missing_form(const Kernel& kernel, const char* form, const char* device);

}  // namespace glift::detail
