#include "report.h"

#include "text.h"

#include <glift/error.h>

#include <algorithm>

namespace glift::detail {

void throw_report(const Kernel& kernel, const StatusRecord& record) {
    if (record.code == StatusRecord::fine) return;
    const bool is_other = record.file != 0 && record.file <= kernel.other_files.size();
    const char* file = is_other ? kernel.other_files[record.file - 1] : kernel.file;
    const std::string where = std::string(file) + ":" + std::to_string(record.line) + ", " + kernel_text(kernel);
    if (record.code == StatusRecord::loop_limit) {
        throw Error(ErrorCode::loop_limit, "a loop ran longer than this device allows; the results are not complete",
                    where, "the device cuts an invocation off after a number of rounds, over all its loops together",
                    loop_remedy);
    }
    std::string address = "(";
    for (std::uint32_t axis = 0; axis < std::min(record.rank, 4u); ++axis) {
        address += (axis ? ", " : "") + std::to_string(static_cast<std::int32_t>(record.address[axis]));
    }
    const char* name = record.binding < kernel.bindings.size() ? kernel.bindings[record.binding].name : "a structure";
    throw Error(ErrorCode::out_of_range, "an access outside a structure", where,
                std::string(name) + " at virtual address " + address + ")",
                "ask first, with contains() or find(); or make the structure larger, or give it an edge");
}

void throw_not_in_recording(const char* call) {
    throw Error(ErrorCode::wrong_argument, "this call cannot be recorded: it waits for the device, or submits", call,
                "what a recording or a command buffer of the program holds has not run yet",
                "call it on the device, outside of the body that is recorded");
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
