// Buffers larger than the device's largest allocation (Context::max_piece_bytes): bound to several allocations, but
// contiguous in device addresses (sparse binding).
#pragma once

#include "vulkan/context.h"

#include <span>

namespace glift::detail {

struct Allocation;

/// The most bytes of one allocation of such a buffer, also where the device allows more.
inline constexpr VkDeviceSize largest_piece = VkDeviceSize(2) << 30;

/// Binds the buffer to the allocations, one after the other from its start on, and waits until that is done.
void bind_pieces(Context& context, VkBuffer buffer, std::span<const Allocation> pieces);

}  // namespace glift::detail
