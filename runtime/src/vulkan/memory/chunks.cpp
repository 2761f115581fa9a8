#include "chunks.h"

#include "text.h"

#include <glift/error.h>

#include <algorithm>

namespace glift::detail {

namespace {

constexpr VkBufferUsageFlags chunk_usage =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
    VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
const char* name_of(MemoryUse use) {
    switch (use) {
    case MemoryUse::parameters: return "glift parameters";
    case MemoryUse::readback: return "glift readback";
    default: return "glift staging";
    }
}

constexpr VkDeviceSize largest_kept = VkDeviceSize(64) << 20;
constexpr std::size_t most_kept = 64;

}  // namespace

ChunkPool::~ChunkPool() { clear(); }

std::unique_ptr<Chunk> ChunkPool::make(MemoryUse use, VkDeviceSize bytes) {
    auto chunk = std::make_unique<Chunk>();
    chunk->pool = this;
    chunk->use = use;
    chunk->bytes = bytes;
    try {
        make_buffer(*chunk);
    } catch (...) {
        destroy(*chunk);
        throw;
    }
    return chunk;
}

void ChunkPool::make_buffer(Chunk& chunk) {
    const VkBufferCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = chunk.bytes, .usage = chunk_usage};
    context_.check(context_.vk.vkCreateBuffer(context_.device, &info, nullptr, &chunk.buffer), "vkCreateBuffer");
    VkMemoryRequirements needs;
    context_.vk.vkGetBufferMemoryRequirements(context_.device, chunk.buffer, &needs);
    const bool is_made = allocator_.allocate(needs, chunk.use, true, chunk.allocation) ||
                         (chunk.use == MemoryUse::parameters &&  // in the host's memory when the device's is full
                          allocator_.allocate(needs, MemoryUse::upload, true, chunk.allocation));
    if (!is_made) {
        throw Error(ErrorCode::out_of_memory,
                    chunk.use == MemoryUse::parameters ? "no memory is left for parameters"
                                                       : "no memory is left for staging buffers",
                    context_.properties.name,
                    size_text(chunk.bytes) + " asked for, " + size_text(allocator_.reserved()) + " in use by Glift",
                    "free structures that are no longer used, or move fewer bytes at a time");
    }
    context_.check(
        context_.vk.vkBindBufferMemory(context_.device, chunk.buffer, chunk.allocation.memory, chunk.allocation.offset),
        "vkBindBufferMemory");
    const VkBufferDeviceAddressInfo address = {.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO,
                                               .buffer = chunk.buffer};
    chunk.address = context_.vk.vkGetBufferDeviceAddress(context_.device, &address);
    context_.set_name(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<std::uint64_t>(chunk.buffer), name_of(chunk.use));
}

std::shared_ptr<Chunk> ChunkPool::take(MemoryUse use, VkDeviceSize bytes) {
    bytes = std::max(bytes, chunk_bytes);
    std::unique_ptr<Chunk> found;
    {
        const std::lock_guard lock(mutex_);
        for (auto& chunk : idle_) {
            if (chunk->use != use || chunk->bytes < bytes || chunk->bytes > 2 * bytes) continue;
            found = std::move(chunk);
            idle_.erase(idle_.begin() + (&chunk - idle_.data()));
            break;
        }
    }
    if (!found) found = make(use, bytes);
    return std::shared_ptr<Chunk>(found.release(), [](Chunk* chunk) {
        ChunkPool& pool = *chunk->pool;
        const std::lock_guard lock(pool.mutex_);
        pool.idle_.emplace_back(chunk);
    });
}

void ChunkPool::destroy(Chunk& chunk) {
    context_.vk.vkDestroyBuffer(context_.device, chunk.buffer, nullptr);
    allocator_.free(chunk.allocation);
}

void ChunkPool::trim() {
    const std::lock_guard lock(mutex_);
    std::size_t kept = 0;
    for (auto& chunk : idle_) {
        if (chunk->bytes <= largest_kept && kept < most_kept) {
            ++kept;
        } else {
            destroy(*chunk);
            chunk.reset();
        }
    }
    std::erase(idle_, nullptr);
}

void ChunkPool::clear() {
    const std::lock_guard lock(mutex_);
    for (auto& chunk : idle_) destroy(*chunk);
    idle_.clear();
}

Slice Arena::take_from_next(VkDeviceSize bytes) {
    std::shared_ptr<Chunk> chunk = pool_->take(use_, bytes);
    chunks_.push_back(std::move(chunk));
    offset_ = bytes;
    end_ = chunks_.back()->bytes;
    return {chunks_.back().get(), 0, chunks_.back()->allocation.mapped};
}

}  // namespace glift::detail
