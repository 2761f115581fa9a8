// Sub-allocates device memory from few large blocks.
#pragma once

#include "vulkan/context.h"

#include <map>
#include <memory>
#include <vector>

namespace glift::detail {

/// What memory is for. `device`: the device alone. `parameters`: small data that the host or a pass writes and later
/// passes read; in device memory, if the device has some that the host can write, so that passes need not read over the
/// bus. `upload`: staging for uploads. `readback`: staging for downloads, and the kernels' status records.
enum class MemoryUse : std::uint8_t { device, parameters, upload, readback };

struct Block;

struct Allocation {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize offset = 0, bytes = 0;
    std::byte* mapped = nullptr;  ///< null: not mapped (images, and memory that is not host-visible)
    Block* block = nullptr;
};

/// Not thread-safe: the device's lock is held around it.
class Allocator {
public:
    explicit Allocator(Context& context);
    ~Allocator();

    /// False if there is no memory of a fitting type left (or GLIFT_MEMORY_LIMIT is reached). `linear`: true for a
    /// buffer, false for an image.
    bool allocate(const VkMemoryRequirements& needs, MemoryUse use, bool linear, Allocation& result);
    void free(const Allocation& allocation);

    std::uint64_t used() const { return used_; }
    std::uint64_t reserved() const { return reserved_; }
    std::uint64_t limit() const { return limit_; }

private:
    struct Pool {
        std::uint32_t type;
        bool linear;
        VkDeviceSize next_block;
        std::vector<std::unique_ptr<Block>> blocks;
    };

    Pool& pool(std::uint32_t type, bool linear);
    Block* add_block(Pool& pool, VkDeviceSize bytes);
    Block* allocate_block(Pool& pool, VkDeviceSize bytes);
    void release_block(Pool& pool, std::size_t index);
    bool release_empty_blocks();
    std::uint64_t empty_bytes() const;
    bool choose_type(std::uint32_t allowed, MemoryUse use, std::uint32_t& type) const;

    Context& context_;
    std::vector<std::unique_ptr<Pool>> pools_;
    std::uint64_t used_ = 0, reserved_ = 0, limit_;
    bool is_cpu_;  ///< the device is a CPU: its memory is the machine's
    /// Of blocks without a memory, which are kept for the next ones: to allocate a temporary of 1 GiB anew for each
    /// call of a pipeline took an H200 40 ms.
    std::uint64_t most_empty_;
};

}  // namespace glift::detail
