// The sizes that subgroups of compute shaders may have, and the one that Glift's kernels run with.
#pragma once

#include "instance.h"

namespace glift::detail {

/// Host code decides by DeviceProperties::subgroup_size. In SPIR-V 1.6 subgroups may have any size between the device's
/// least and greatest, so kernels that use subgroups require that size.
struct SubgroupSizes {
    SubgroupSizes() = default;
    SubgroupSizes(const Instance& instance, VkPhysicalDevice physical);

    std::uint32_t size = 1;  ///< the device's own choice, between `least` and `greatest`
    std::uint32_t least = 1, greatest = 1;
    std::uint32_t most_in_workgroup = UINT32_MAX;  ///< subgroups of a workgroup, where a size is required
    bool can_require = false;                      ///< of compute shaders

    bool vary() const { return least < greatest; }
    /// Whether kernels may use subgroups: it is certain which size they run with.
    bool is_certain() const { return !vary() || can_require; }
};

}  // namespace glift::detail
