#include "descriptor_limits.h"

#include "../text.h"

#include <glift/error.h>

#include <algorithm>

namespace glift::detail {

namespace {

std::uint32_t buffer_limit(const VkPhysicalDeviceLimits& limits) {
    return std::min(limits.maxPerStageDescriptorStorageBuffers, limits.maxDescriptorSetStorageBuffers);
}

}  // namespace

DescriptorCounts count_descriptors(const Kernel& kernel, const Form& form) {
    DescriptorCounts counts;
    for (const Binding& binding : kernel.bindings) {
        if (binding.kind == MemoryKind::buffer) ++counts.buffers;
        else if (binding.sampled) ++counts.sampled_images;
        else ++counts.storage_images;
    }
    counts.parameter_buffers = !form.push_constants && form.parameter_bytes ? 1 : 0;
    counts.status_buffers = kernel.reports ? 1 : 0;
    counts.message_buffers = kernel.messages.empty() ? 0 : 1;
    return counts;
}

bool buffers_fit(const Context& context, const Kernel& kernel) {
    const VkPhysicalDeviceLimits& limits = context.core.limits;
    // Most kernels have few bindings. The parameters, the status record and the messages are three more
    // descriptors.
    if (kernel.bindings.size() + 3 <= std::min(buffer_limit(limits), limits.maxPerStageResources)) return true;
    const DescriptorCounts counts = count_descriptors(kernel, kernel.general);
    return counts.buffers == 0 ||
           (counts.storage_buffers() <= buffer_limit(limits) && counts.all() <= limits.maxPerStageResources);
}

void check_descriptors(const Context& context, const Kernel& kernel, const DescriptorCounts& counts) {
    const VkPhysicalDeviceLimits& limits = context.core.limits;
    const struct {
        const char* what;
        std::uint32_t count, limit;
    } checks[] = {
        {"storage buffers", counts.storage_buffers(), buffer_limit(limits)},
        {"storage images", counts.storage_images,
         std::min(limits.maxPerStageDescriptorStorageImages, limits.maxDescriptorSetStorageImages)},
        {"sampled images", counts.sampled_images,
         std::min(limits.maxPerStageDescriptorSampledImages, limits.maxDescriptorSetSampledImages)},
        {"samplers", counts.sampled_images,
         std::min(limits.maxPerStageDescriptorSamplers, limits.maxDescriptorSetSamplers)},
        {"buffers and images", counts.all(), limits.maxPerStageResources},
    };
    for (const auto& check : checks) {
        if (check.count <= check.limit) continue;
        throw Error(ErrorCode::too_large,
                    "the kernel takes " + std::to_string(check.count) + " " + check.what + ", more than the device has",
                    kernel_text(kernel),
                    context.properties.name + " has " + std::to_string(check.limit) + " for one kernel",
                    "split the kernel, or keep several images' texels in one buffer");
    }
}

}  // namespace glift::detail
