#include "report.h"

#include "objects.h"
#include "text.h"

#include <glift/error.h>

#include <algorithm>

namespace glift::detail {

Reporter::Reporter(const Kernel& reporting)
    : kernel(kernel_text(reporting)), files(reporting.other_files.begin(), reporting.other_files.end()) {
    files.insert(files.begin(), reporting.file);
    for (const Binding& binding : reporting.bindings) bindings.emplace_back(binding.name);
}

/// A coordinate of an address outside a structure, as text. A value above 2^32 - 2^16 is shown as a negative number,
/// since it is most likely the result of a subtraction that wrapped around.
static std::string shown_coordinate(std::uint32_t at) {
    constexpr std::uint32_t farthest_below_zero = 1u << 16;
    return at > 0u - farthest_below_zero ? std::to_string(static_cast<std::int32_t>(at)) : std::to_string(at);
}

void throw_report(const Reporter& reporter, const StatusRecord& record) {
    if (record.code == StatusRecord::fine) return;
    const std::string& file = reporter.files[record.file < reporter.files.size() ? record.file : 0];
    const std::string where = file + ":" + std::to_string(record.line) + ", " + reporter.kernel;
    if (record.code == StatusRecord::loop_limit) {
        throw Error(ErrorCode::loop_limit, "a loop ran longer than this device allows; the results are not complete",
                    where, "the device ends an invocation after a number of iterations, summed over all its loops",
                    loop_remedy);
    }
    std::string address = "(";
    for (std::uint32_t axis = 0; axis < std::min(record.rank, 4u); ++axis)
        address += (axis ? ", " : "") + shown_coordinate(record.address[axis]);
    const std::string name =
        record.binding < reporter.bindings.size() ? reporter.bindings[record.binding] : "a structure";
    throw Error(ErrorCode::out_of_range, "an access outside a structure", where,
                name + " at virtual address " + address + ")",
                "ask first, with contains() or find(); or make the structure larger, or give it an edge");
}

void throw_not_in_recording(const char* call) {
    throw Error(ErrorCode::wrong_argument, "this call cannot be recorded: it waits for the device, or submits", call,
                "what a recording or a command buffer of the program holds has not run yet",
                "call it on the device, outside of the body that is recorded");
}

void throw_replaced_in_recording() {
    throw Error(ErrorCode::wrong_argument, "a container's member gets other memory in a recording", "Commands::replace",
                "what is recorded runs later, perhaps many times, on the memory that it was recorded with",
                "call the pipeline that does so on the device, before the recording");
}

void require_current(std::span<const Memory> memories) {
    for (const Memory& memory : memories) {
        if (!memory.object()->is_replaced()) continue;
        throw Error(ErrorCode::given_up, "a recording uses memory that its container has given up",
                    memory_text(memory.description()), "a pipeline gave the container's member other memory since then",
                    "record again");
    }
}

void throw_given_up(const MemoryObject& memory, std::string where) {
    throw Error(ErrorCode::given_up, "memory is used that its container has given up",
                std::move(where) + ", " + memory_text(memory.description()),
                "a pipeline gave the container's member other memory after this structure was made over it",
                "make the structure again, over the member as it is now");
}

void throw_closed(std::string where) {
    throw Error(ErrorCode::wrong_argument, "commands were kept beyond the recording that they belong to",
                std::move(where),
                "a recording takes commands until the body of Device::record returns, a command buffer until "
                "glift::vulkan::finish",
                "use the device, glift::Commands(device), or record again");
}

void throw_missing_form(const Kernel& kernel, const char* form, const char* device) {
    throw Error(ErrorCode::missing_form, std::string("the kernel has no ") + form + " form for " + device,
                kernel_text(kernel), {}, "compile it with gliftc for this kind of device");
}

}  // namespace glift::detail
