// Selects a physical device by `gpu`, `lavapipe` or part of its name; without any of these, the best that can be used.
#pragma once

#include "instance.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glift::detail {

/// Throws no_device, with a list of what is there, if no device fits; unsupported_version or missing_feature if none of
/// those that fit can be used, for example because they lack one of the extensions.
VkPhysicalDevice select_physical_device(const Instance& instance, std::string_view which,
                                        std::span<const std::string> extensions);

std::vector<VkQueueFamilyProperties> queue_families(const Instance& instance, VkPhysicalDevice physical);

}  // namespace glift::detail
