// The one exception of the library.
#pragma once

#include <glift/api.h>

#include <cstdint>
#include <exception>
#include <string>

namespace glift {

enum class ErrorCode : std::uint8_t {
    no_loader,  ///< the library libvulkan.so.1, or the one that GLIFT_VULKAN_LOADER names, is missing or is not a
                ///< Vulkan loader
    no_device,  ///< no Vulkan driver, no device, or none of the kind or name asked for
    unsupported_version,  ///< the loader's or the device's Vulkan is older than 1.3
    /// The device or its driver lacks what Glift, a kernel or the program asks for: a feature, an extension, a texel
    /// format, a queue that computes, timestamps. Or an adopted image lacks a usage or creation flag.
    missing_feature,
    missing_layer,  ///< GLIFT_VALIDATE=1 and no validation layer installed
    out_of_memory,
    /// Beyond a limit of the device (for example of a memory, an image, workgroups, descriptors) or of Glift (for
    /// example a number of elements past 2^32 - 1, a domain too large to search, a viewport).
    too_large,
    aliased_memory,  ///< memory passed twice in one call, where one use may write what another one accesses
    given_up,        ///< memory in place of which the container's member now has other memory
    wrong_argument,  ///< any other mistake: in a call, a handle, a recording, a file name, an environment variable
    loop_limit,      ///< a kernel's loops run, or may run, for more rounds than the device allows
    out_of_range,    ///< an access outside a structure, in a kernel compiled with `gliftc --checked`; else not reported
    assertion_failed,  ///< an `assert` of a kernel; thrown by the call that waits for the device
    bad_file,          ///< a file that is damaged, cut off, or of no format that glift/files.h reads
    device_lost,
    missing_form,  ///< the kernel has no code for this kind of device, or not in the form that the call needs
    lost_rank,     ///< another rank of the program does not answer, or has ended (ranks/world.h)
    vulkan,        ///< any other failed Vulkan call
};

/// what() is `problem\n  where: …\n  why: …\n  remedy: …`, without the lines whose text is empty.
class GLIFT_API Error : public std::exception {
public:
    Error(ErrorCode code, std::string problem, std::string where = {}, std::string why = {}, std::string remedy = {});

    const char* what() const noexcept override { return text_.c_str(); }
    ErrorCode code() const { return code_; }
    const std::string& problem() const { return problem_; }  ///< what went wrong
    /// What the error is about: for example a call, a kernel or statement (with file and line), a memory, a device's
    /// name, or VARIABLE=value.
    const std::string& where() const { return where_; }
    const std::string& why() const { return why_; }        ///< the cause; may be empty
    const std::string& remedy() const { return remedy_; }  ///< what to do

private:
    ErrorCode code_;
    std::string problem_, where_, why_, remedy_, text_;
};

}  // namespace glift
