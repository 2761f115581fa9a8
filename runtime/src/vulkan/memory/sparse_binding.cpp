#include "sparse_binding.h"

#include "allocator.h"

#include <vector>

namespace glift::detail {

void bind_pieces(Context& context, VkBuffer buffer, std::span<const Allocation> pieces) {
    std::vector<VkSparseMemoryBind> binds;
    VkDeviceSize offset = 0;
    for (const Allocation& piece : pieces) {
        binds.push_back(
            {.resourceOffset = offset, .size = piece.bytes, .memory = piece.memory, .memoryOffset = piece.offset});
        offset += piece.bytes;
    }
    const VkSparseBufferMemoryBindInfo of_buffer = {
        .buffer = buffer, .bindCount = static_cast<std::uint32_t>(binds.size()), .pBinds = binds.data()};
    const VkBindSparseInfo info = {
        .sType = VK_STRUCTURE_TYPE_BIND_SPARSE_INFO, .bufferBindCount = 1, .pBufferBinds = &of_buffer};
    const VkFenceCreateInfo fence_info = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkFence fence = VK_NULL_HANDLE;
    context.check(context.vk.vkCreateFence(context.device, &fence_info, nullptr, &fence), "vkCreateFence");
    VkResult result = context.vk.vkQueueBindSparse(context.queue, 1, &info, fence);
    if (result == VK_SUCCESS) result = context.vk.vkWaitForFences(context.device, 1, &fence, VK_TRUE, UINT64_MAX);
    context.vk.vkDestroyFence(context.device, fence, nullptr);
    context.check(result, "vkQueueBindSparse");
}

}  // namespace glift::detail
