// GLIFT_PROFILE: a profile of every device that the process opens or adopts.
#pragma once

#include "../objects.h"

namespace glift::detail {

/// Turns the device's profiler on if GLIFT_PROFILE is set: `summary` prints a table on standard error at exit, a name
/// that ends with `.json` is the file to which a trace is written then. Throws wrong_argument for another value, and
/// missing_feature as Profile does.
void profile_if_asked(const std::shared_ptr<DeviceObject>& device);

/// Prints or writes the report now: for processes that end without the handlers of exit.
void report_profile();

/// Keeps what was collected of a device that GLIFT_PROFILE profiles and that is being destroyed.
void keep_profile(const DeviceObject& device);

}  // namespace glift::detail
