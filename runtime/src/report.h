// Errors that a kernel reported through its StatusRecord, and errors of calls that cannot be recorded, come after the
// end of a recording, use memory that a container has given up, or need a form that the kernel lacks.
#pragma once

#include <glift/commands.h>
#include <glift/pass.h>

#include <span>
#include <string>
#include <vector>

namespace glift::detail {

/// The remedy for loops that exceed a device's limit.
inline constexpr const char* loop_remedy =
    "split the work over more invocations or dispatches, or run on another device "
    "(GLIFT_DEVICE=gpu or GLIFT_DEVICE=host)";

/// The names that reports about a kernel contain. Copied, since the kernel's library may be unloaded before the report
/// is read.
struct Reporter {
    explicit Reporter(const Kernel& kernel);

    std::string kernel;  ///< as errors name it
    std::vector<std::string> bindings;
    std::vector<std::string> files;  ///< by StatusRecord::file
};

/// Throws loop_limit or out_of_range if the record says so.
void throw_report(const Reporter& reporter, const StatusRecord& record);

/// Throws the error for commands given after their recording, or the user's command buffer, was finished.
[[noreturn]] void throw_closed(std::string where);
/// Throws the error for a container's member that gets other memory within a recording.
[[noreturn]] void throw_replaced_in_recording();
/// Throws if a recording uses memory that its container has given up.
void require_current(std::span<const Memory> memories);
/// Throws the error for a call that is given memory which a container has given up.
[[noreturn]] void throw_given_up(const MemoryObject& memory, std::string where);
[[noreturn]] void throw_missing_form(const Kernel& kernel, const char* form, const char* device);

}  // namespace glift::detail
