// Whether a pass can be distributed, and over what.
#pragma once

#include "coverage.h"

#include <optional>
#include <vector>

namespace glift::detail {

/// A pass of which each rank computes the elements that it owns.
struct PassPlan {
    std::shared_ptr<Space> space;
    std::uint32_t origin = 0;   ///< dense: the last coordinate of the first element that is visited
    std::uint32_t size = 0;     ///< and how many are visited along that axis
    std::uint32_t covered = 1;  ///< elements along that axis that a Vulkan device visits together
    std::vector<std::optional<SlabLayout>> layouts;  ///< dense: of each binding's memory, as the call's ranges have it
    std::vector<std::size_t> scattered;  ///< bindings whose writes to any element of a replicated memory are combined
    std::uint32_t radius = 0;            ///< the largest of the windows that are read
    bool is_whole = true;                ///< all elements of the space are visited
};

/// Nullopt: every rank has to run the whole pass. `is_host`: on the host device, which visits no more than it has to.
std::optional<PassPlan> plan_of(const Kernel& kernel, const Call& call, Coverages& coverages, SlabLayouts& layouts,
                                std::span<const std::shared_ptr<Space>> paged_spaces, bool is_host);

}  // namespace glift::detail
