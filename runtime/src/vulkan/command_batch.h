// A command buffer and what must live as long as it: parameters, staging, descriptor sets.
#pragma once

#include "command_pool.h"
#include "pass_times.h"
#include "pipelines.h"
#include "vulkan/memory/chunks.h"

namespace glift::detail {

/// Descriptor sets, for devices whose push descriptors are absent or too few.
class DescriptorSets {
public:
    explicit DescriptorSets(Context& context) : context_(context) {}
    ~DescriptorSets();
    VkDescriptorSet take(const Pipeline& pipeline);
    [[nodiscard]] bool reset();  ///< false: it failed, and the sets are unusable

private:
    void add_pool(const Pipeline& pipeline);

    Context& context_;
    std::vector<VkDescriptorPool> pools_;  // the last one is being filled
};

struct CommandBatch {
    CommandBatch(Context& context, ChunkPool& chunks);
    CommandBatch(const CommandBatch&) = delete;

    void begin(VkCommandBufferUsageFlags usage) { pool.begin(usage); }
    [[nodiscard]] bool reset();  ///< false: it failed, and the batch is unusable

    Context& context;
    CommandPool pool;
    const VkCommandBuffer commands;
    Arena parameters, upload, readback;
    DescriptorSets sets;
    std::shared_ptr<RecordedTimes> times;  ///< of a recording that was made while the device was profiled; else null
    std::uint64_t value = 0;               ///< the timeline's value once the device is done with it
    std::uint64_t gate = 0;                ///< Timeline's, which holds it back; 0: none
    std::uint64_t operations = 0;          ///< recorded
    std::uint64_t passes = 0;              ///< calls of kernels in a recording
    bool prints = false;                   ///< some kernel has messages
};

}  // namespace glift::detail
