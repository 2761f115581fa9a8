// Host-visible buffers for parameters, staging and readback: slices of chunks, which are pooled.
#pragma once

#include "allocator.h"

#include <memory>
#include <mutex>
#include <vector>

namespace glift::detail {

class ChunkPool;

/// A buffer from which slices are taken. It returns to its pool when the last reference is gone, which must be after
/// the device is done with it.
struct Chunk {
    ChunkPool* pool = nullptr;
    MemoryUse use = MemoryUse::upload;
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize bytes = 0;
    VkDeviceAddress address = 0;
    Allocation allocation;
};

struct Slice {
    Chunk* chunk = nullptr;
    VkDeviceSize offset = 0;
    std::byte* data = nullptr;

    VkBuffer buffer() const { return chunk->buffer; }
    VkDeviceAddress address() const { return chunk->address + offset; }
};

class ChunkPool {
public:
    ChunkPool(Context& context, Allocator& allocator) : context_(context), allocator_(allocator) {}
    ~ChunkPool();
    ChunkPool(const ChunkPool&) = delete;

    /// The device's lock is held. Throws out_of_memory.
    std::shared_ptr<Chunk> take(MemoryUse use, VkDeviceSize bytes);

    /// The device's lock is held. `trim` destroys idle chunks that are larger than largest_kept or more than
    /// most_kept (chunks.cpp); `clear` destroys all idle chunks.
    void trim();
    void clear();

    static constexpr VkDeviceSize chunk_bytes = VkDeviceSize(1) << 20;

private:
    std::unique_ptr<Chunk> make(MemoryUse use, VkDeviceSize bytes);
    void make_buffer(Chunk& chunk);
    void destroy(Chunk& chunk);

    Context& context_;
    Allocator& allocator_;
    std::mutex mutex_;  // chunks are returned from any thread
    std::vector<std::unique_ptr<Chunk>> idle_;
};

/// A bump allocator of slices; holds the chunks that they lie in.
class Arena {
public:
    explicit Arena(ChunkPool& pool, MemoryUse use) : pool_(&pool), use_(use) {}

    Slice take(VkDeviceSize bytes) {
        const VkDeviceSize begin = (offset_ + alignment - 1) & ~(alignment - 1);
        if (begin + bytes > end_) return take_from_next(bytes);
        offset_ = begin + bytes;
        Chunk* chunk = chunks_.back().get();
        return {chunk, begin, chunk->allocation.mapped + begin};
    }

    const std::shared_ptr<Chunk>& current() const { return chunks_.back(); }
    void clear() {
        chunks_.clear();
        offset_ = end_ = 0;
    }

    static constexpr VkDeviceSize alignment = 256;  // no device requires more of storage or uniform buffers

private:
    Slice take_from_next(VkDeviceSize bytes);

    ChunkPool* pool_;
    MemoryUse use_;
    VkDeviceSize offset_ = 0, end_ = 0;
    std::vector<std::shared_ptr<Chunk>> chunks_;
};

}  // namespace glift::detail
