// The one exception of the library.
#pragma once

#include <glift/api.h>

#include <cstdint>
#include <exception>
#include <string>

namespace glift {

enum class ErrorCode : std::uint8_t {
    no_loader,            ///< no Vulkan loader on this machine
    no_device,            ///< no device, or none of the kind or name asked for
    unsupported_version,  ///< Vulkan older than 1.3
    missing_feature,      ///< a feature or extension that Glift needs is absent
    missing_layer,        ///< GLIFT_VALIDATE=1 and no validation layer installed
    out_of_memory,
    too_large,       ///< beyond a limit of the device
    aliased_memory,  ///< one memory passed twice in one call, and written
    wrong_argument,  ///< a call that does not fit its kernel or memory
    loop_limit,      ///< a kernel's loops run longer than the device allows
    out_of_range,    ///< a checked build: an access outside a structure
    device_lost,
    missing_form,  ///< the kernel was not compiled for this device
    vulkan,        ///< any other failed Vulkan call
};

/// Printed by what() as `problem\n  where: …\n  why: …\n  remedy: …`, without the lines that are empty.
class GLIFT_API Error : public std::exception {
public:
    Error(ErrorCode code, std::string problem, std::string where = {}, std::string why = {}, std::string remedy = {});

    const char* what() const noexcept override { return text_.c_str(); }
    ErrorCode code() const { return code_; }
    const std::string& problem() const { return problem_; }  ///< what went wrong
    const std::string& where() const { return where_; }      ///< the call, kernel (with file and line) or memory
    const std::string& why() const { return why_; }          ///< the cause, with the numbers
    const std::string& remedy() const { return remedy_; }    ///< what to do

private:
    ErrorCode code_;
    std::string problem_, where_, why_, remedy_, text_;
};

}  // namespace glift
