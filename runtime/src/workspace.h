// Sub-allocates the temporaries of a recording: those with disjoint lifetimes may share storage.
#pragma once

#include "free_ranges.h"

#include <glift/memory.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace glift::detail {

class MemoryObject;

/// What storage a memory needs on a device.
struct StorageNeeds {
    std::uint64_t bytes = 0, alignment = 1;
    bool shares = true;  ///< false: it has storage of its own
};

/// Hands out places in blocks of storage, which are allocated elsewhere, one allocation for each block. Temporaries
/// cannot move once they are placed: each takes the first gap that is large enough, else a new block of its size.
/// Thread-safe, since handles may be released on any thread.
class Workspace {
public:
    struct Place {
        std::size_t block = 0;
        std::uint64_t offset = 0, bytes = 0;
        bool is_new_block = false;  ///< else the storage is reused
        /// Of a place that is reused: storage (this or other) was freed since the last reuse, and earlier commands may
        /// still use it.
        bool is_just_free = false;
    };

    /// The place of a memory that shares storage with others (StorageNeeds::shares).
    Place take(const StorageNeeds& needs);
    void give_back(const Place& place);

    /// Counts the bytes of a memory with storage of its own.
    void add(std::uint64_t bytes);

    std::uint64_t bytes() const;  ///< of all blocks and of what `add` counted

private:
    mutable std::mutex mutex_;
    std::vector<FreeRanges> blocks_;
    std::uint64_t bytes_ = 0;
    bool was_given_back_ = false;
};

/// A handle to a temporary; its place is freed when the last copy of the handle is gone, though recorded commands may
/// hold the object itself (`kept`) for longer.
Memory temporary(std::shared_ptr<MemoryObject> object, std::shared_ptr<Workspace> workspace,
                 const Workspace::Place& place);

/// A handle for recorded commands: keeps the object alive, but does not keep a temporary's place taken.
Memory kept(const Memory& memory);

}  // namespace glift::detail
