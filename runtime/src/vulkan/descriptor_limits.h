// How many descriptors a kernel takes, and how many the device has.
#pragma once

#include "context.h"

#include <glift/pass.h>

namespace glift::detail {

struct DescriptorCounts {
    std::uint32_t buffers = 0;  ///< memories that are buffers
    std::uint32_t parameter_buffers = 0, status_buffers = 0, message_buffers = 0;
    std::uint32_t storage_images = 0, sampled_images = 0;

    std::uint32_t storage_buffers() const { return buffers + parameter_buffers + status_buffers + message_buffers; }
    std::uint32_t all() const { return storage_buffers() + storage_images + sampled_images; }
};

/// The counts of a form that has a descriptor for each memory. The general form has none for memories that are buffers:
/// for it, the caller sets `buffers` to 0.
DescriptorCounts count_descriptors(const Kernel& kernel, const Form& form);

/// Whether the device has enough descriptors for forms that take one for each buffer: enough for buffers, and enough
/// for buffers and images together. Where not, the general form is needed. True for kernels without buffers, whose
/// general form would have no fewer. Limits of images alone are left to check_descriptors().
bool buffers_fit(const Context& context, const Kernel& kernel);

/// Throws too_large, naming the kernel, the number and the limit, where the device has too few.
void check_descriptors(const Context& context, const Kernel& kernel, const DescriptorCounts& counts);

}  // namespace glift::detail
