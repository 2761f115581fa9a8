#include "command_batch.h"

#include <iterator>

namespace glift::detail {

DescriptorSets::~DescriptorSets() {
    for (VkDescriptorPool pool : pools_) context_.vk.vkDestroyDescriptorPool(context_.device, pool, nullptr);
}

void DescriptorSets::add_pool(const Pipeline& pipeline) {
    constexpr std::uint32_t sets = 256;
    const VkDescriptorPoolSize sizes[] = {
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, sets + pipeline.uniform_buffers},
        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 4 * sets + pipeline.storage_buffers},
        {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 2 * sets + pipeline.storage_images},
        {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2 * sets + pipeline.sampled_images}};
    const VkDescriptorPoolCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                             .maxSets = sets,
                                             .poolSizeCount = static_cast<std::uint32_t>(std::size(sizes)),
                                             .pPoolSizes = sizes};
    VkDescriptorPool pool = VK_NULL_HANDLE;
    context_.check(context_.vk.vkCreateDescriptorPool(context_.device, &info, nullptr, &pool),
                   "vkCreateDescriptorPool");
    pools_.push_back(pool);
}

VkDescriptorSet DescriptorSets::take(const Pipeline& pipeline) {
    if (pools_.empty()) add_pool(pipeline);
    for (bool grown = false;; grown = true) {
        const VkDescriptorSetAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                                  .descriptorPool = pools_.back(),
                                                  .descriptorSetCount = 1,
                                                  .pSetLayouts = &pipeline.set_layout};
        VkDescriptorSet set = VK_NULL_HANDLE;
        const VkResult result = context_.vk.vkAllocateDescriptorSets(context_.device, &info, &set);
        if (result == VK_SUCCESS) return set;
        const bool full = result == VK_ERROR_OUT_OF_POOL_MEMORY || result == VK_ERROR_FRAGMENTED_POOL;
        if (grown || !full) context_.fail(result, "vkAllocateDescriptorSets");
        add_pool(pipeline);
    }
}

bool DescriptorSets::reset() {
    // One pool is kept; a batch that needed several is rare.
    while (pools_.size() > 1) {
        context_.vk.vkDestroyDescriptorPool(context_.device, pools_.back(), nullptr);
        pools_.pop_back();
    }
    return pools_.empty() || context_.vk.vkResetDescriptorPool(context_.device, pools_.back(), 0) == VK_SUCCESS;
}

CommandBatch::CommandBatch(Context& context_, ChunkPool& chunks)
    : context(context_), pool(context_, context_.queue_family), commands(pool.commands()),
      parameters(chunks, MemoryUse::parameters), upload(chunks, MemoryUse::upload),
      readback(chunks, MemoryUse::readback), sets(context_) {}

bool CommandBatch::reset() {
    parameters.clear();
    upload.clear();
    readback.clear();
    operations = passes = gate = 0;
    times.reset();
    prints = false;
    return pool.reset() && sets.reset();
}

}  // namespace glift::detail
