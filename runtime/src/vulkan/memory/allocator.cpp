#include "allocator.h"

#include "environment.h"
#include "free_ranges.h"
#include "machine_memory.h"

#include <algorithm>

namespace glift::detail {

struct Block {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize bytes = 0, used = 0;
    std::byte* mapped = nullptr;
    FreeRanges free;
    std::size_t pool = 0;
};

namespace {

/// Sub-allocates from the block and sets `offset`; false if the block has no room.
bool take(Block& block, VkDeviceSize bytes, VkDeviceSize alignment, VkDeviceSize& offset) {
    const auto found = block.free.take(bytes, alignment);
    if (!found) return false;
    offset = *found;
    block.used += bytes;
    return true;
}

constexpr VkDeviceSize first_block = VkDeviceSize(16) << 20;
constexpr VkDeviceSize largest_block = VkDeviceSize(256) << 20;

}  // namespace

Allocator::Allocator(Context& context)
    : context_(context), limit_(memory_limit()), is_cpu_(context.properties.kind == DeviceKind::cpu),
      most_empty_(std::max(largest_block, context.properties.memory_bytes / (is_cpu_ ? 32 : 8))) {}

Allocator::~Allocator() {
    for (auto& pool : pools_) {
        while (!pool->blocks.empty()) release_block(*pool, pool->blocks.size() - 1);
    }
}

bool Allocator::choose_type(std::uint32_t allowed, MemoryUse use, std::uint32_t& type) const {
    constexpr VkMemoryPropertyFlags device = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    constexpr VkMemoryPropertyFlags visible =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    VkMemoryPropertyFlags needed = 0, liked = 0, disliked = 0;
    switch (use) {
    case MemoryUse::device: liked = device; break;
    case MemoryUse::parameters:
        needed = visible;
        liked = device;
        break;
    case MemoryUse::upload:
        needed = visible;
        disliked = device;
        break;
    case MemoryUse::readback:
        needed = visible;
        liked = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
        disliked = device;
        break;
    }
    int best = -1;
    for (std::uint32_t k = 0; k < context_.memory.memoryTypeCount; ++k) {
        const VkMemoryPropertyFlags flags = context_.memory.memoryTypes[k].propertyFlags;
        constexpr VkMemoryPropertyFlags odd = VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT |
                                              VK_MEMORY_PROPERTY_PROTECTED_BIT |
                                              VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD;
        if (!(allowed >> k & 1) || (flags & needed) != needed || (flags & odd)) continue;
        const int score = 1 + ((flags & liked) == liked ? 2 : 0) + (flags & disliked ? 0 : 1);
        if (score > best) {
            best = score;
            type = k;
        }
    }
    return best > 0;
}

Allocator::Pool& Allocator::pool(std::uint32_t type, bool linear) {
    for (auto& pool : pools_) {
        if (pool->type == type && pool->linear == linear) return *pool;
    }
    pools_.push_back(std::make_unique<Pool>(Pool{type, linear, first_block, {}}));
    return *pools_.back();
}

Block* Allocator::add_block(Pool& pool, VkDeviceSize bytes) {
    if (reserved_ + bytes > limit_) return nullptr;
    if (is_cpu_ && !hold_machine_memory(bytes)) return nullptr;
    Block* const made = allocate_block(pool, bytes);
    if (is_cpu_ && !made) release_machine_memory(bytes);
    return made;
}

Block* Allocator::allocate_block(Pool& pool, VkDeviceSize bytes) {
    const VkMemoryAllocateFlagsInfo flags = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO,
                                             .flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT};
    const VkMemoryAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                       .pNext = pool.linear ? &flags : nullptr,
                                       .allocationSize = bytes,
                                       .memoryTypeIndex = pool.type};
    auto block = std::make_unique<Block>(Block{.bytes = bytes, .free = FreeRanges(bytes)});
    const VkResult result = context_.vk.vkAllocateMemory(context_.device, &info, nullptr, &block->memory);
    if (result == VK_ERROR_DEVICE_LOST) context_.fail(result, "vkAllocateMemory");
    if (result != VK_SUCCESS) return nullptr;
    if (context_.memory.memoryTypes[pool.type].propertyFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT && pool.linear) {
        void* mapped = nullptr;
        const VkResult mapping = context_.vk.vkMapMemory(context_.device, block->memory, 0, VK_WHOLE_SIZE, 0, &mapped);
        if (mapping != VK_SUCCESS) {
            context_.vk.vkFreeMemory(context_.device, block->memory, nullptr);
            if (mapping == VK_ERROR_DEVICE_LOST) context_.fail(mapping, "vkMapMemory");
            return nullptr;
        }
        block->mapped = static_cast<std::byte*>(mapped);
    }
    reserved_ += bytes;
    for (std::size_t k = 0; k < pools_.size(); ++k) {
        if (pools_[k].get() == &pool) block->pool = k;
    }
    pool.blocks.push_back(std::move(block));
    return pool.blocks.back().get();
}

void Allocator::release_block(Pool& pool, std::size_t index) {
    Block& block = *pool.blocks[index];
    reserved_ -= block.bytes;
    if (is_cpu_) release_machine_memory(block.bytes);
    context_.vk.vkFreeMemory(context_.device, block.memory, nullptr);
    pool.blocks.erase(pool.blocks.begin() + static_cast<std::ptrdiff_t>(index));
}

std::uint64_t Allocator::empty_bytes() const {
    std::uint64_t bytes = 0;
    for (const auto& pool : pools_)
        for (const auto& block : pool->blocks)
            if (!block->used) bytes += block->bytes;
    return bytes;
}

// Frees the empty blocks that are kept for reuse, to make room for a memory that does not fit in them. False if there
// were none.
bool Allocator::release_empty_blocks() {
    const std::uint64_t before = reserved_;
    for (auto& pool : pools_) {
        for (std::size_t k = pool->blocks.size(); k-- > 0;) {
            if (!pool->blocks[k]->used) release_block(*pool, k);
        }
    }
    return reserved_ < before;
}

bool Allocator::allocate(const VkMemoryRequirements& needs, MemoryUse use, bool linear, Allocation& result) {
    std::uint32_t type = 0;
    if (!choose_type(needs.memoryTypeBits, use, type)) return false;
    Pool& from = pool(type, linear);
    const VkDeviceSize alignment = std::max<VkDeviceSize>(needs.alignment, 256);
    Block* block = nullptr;
    VkDeviceSize offset = 0;
    for (auto& candidate : from.blocks) {
        // An empty block that was a large memory waits for one as large: the next call's temporary.
        const bool is_for_larger = candidate->bytes > largest_block && needs.size < candidate->bytes / 2;
        if (!is_for_larger && take(*candidate, needs.size, alignment, offset)) {
            block = candidate.get();
            break;
        }
    }
    if (!block) {
        // Large memories get a block of their own; small ones open a block that others share, each twice as large as
        // the one before, up to largest_block. Where there is no room for that, they get one of their own size, too.
        if (needs.size * 2 <= from.next_block) block = add_block(from, from.next_block);
        if (block) from.next_block = std::min(from.next_block * 2, largest_block);
        if (!block) block = add_block(from, needs.size);
        if (!block && release_empty_blocks()) block = add_block(from, needs.size);
        if (!block || !take(*block, needs.size, alignment, offset)) return false;
    }
    used_ += needs.size;
    result = {block->memory, offset, needs.size, block->mapped ? block->mapped + offset : nullptr, block};
    return true;
}

void Allocator::free(const Allocation& allocation) {
    if (!allocation.block) return;
    allocation.block->free.give_back(allocation.offset, allocation.bytes);
    allocation.block->used -= allocation.bytes;
    used_ -= allocation.bytes;
    if (allocation.block->used) return;
    if (empty_bytes() <= most_empty_) return;
    Pool& pool = *pools_[allocation.block->pool];
    for (std::size_t k = 0; k < pool.blocks.size(); ++k) {
        if (pool.blocks[k].get() == allocation.block) return release_block(pool, k);
    }
}

}  // namespace glift::detail
