// Where the temporaries of a recording lie: those whose lives do not meet share storage.
#pragma once

#include "free_ranges.h"

#include <glift/memory.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace glift::detail {

class MemoryObject;

/// What a memory takes of a device.
struct StorageNeeds {
    std::uint64_t bytes = 0, alignment = 1;
    bool shares = true;  ///< false: it has storage of its own
};

/// A plan, without the storage itself. Storage comes in blocks, since what was placed does not move: a temporary takes
/// the first gap that is large enough, else a new block of its size. Safe for several threads: handles go where they
/// want.
class Workspace {
public:
    struct Place {
        std::size_t block = 0;
        std::uint64_t offset = 0, bytes = 0;
        bool is_new_block = false;  ///< else others had this storage before
        bool is_just_free = false;  ///< storage was given back since the last place was taken: work may still be on it
    };

    /// Of what shares storage.
    Place take(const StorageNeeds& needs);
    void give_back(const Place& place);

    /// Counts what has storage of its own.
    void add(std::uint64_t bytes);

    std::uint64_t bytes() const;  ///< all in all

private:
    mutable std::mutex mutex_;
    std::vector<FreeRanges> blocks_;
    std::uint64_t bytes_ = 0;
    bool was_given_back_ = false;
};

/// A handle to a temporary; its place is free again when the last one is gone, though commands that were recorded may
/// hold the object itself (`kept`) for longer.
Memory temporary(std::shared_ptr<MemoryObject> object, std::shared_ptr<Workspace> workspace,
                 const Workspace::Place& place);

/// The memory as recorded commands hold it: its storage stays, which is no use of a temporary.
Memory kept(const Memory& memory);

}  // namespace glift::detail
