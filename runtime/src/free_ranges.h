// First-fit sub-allocation of a block of storage.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace glift::detail {

/// Not safe for several threads.
class FreeRanges {
public:
    explicit FreeRanges(std::uint64_t bytes) : free_{{0, bytes}} {}

    /// Takes bytes from the first free range that has room for them, and returns their aligned offset; nullopt if no
    /// range has room.
    std::optional<std::uint64_t> take(std::uint64_t bytes, std::uint64_t alignment) {
        for (auto it = free_.begin(); it != free_.end(); ++it) {
            const auto [begin, size] = *it;
            const std::uint64_t offset = (begin + alignment - 1) / alignment * alignment;
            if (offset + bytes > begin + size) continue;
            free_.erase(it);
            if (offset > begin) free_[begin] = offset - begin;
            if (begin + size > offset + bytes) free_[offset + bytes] = begin + size - offset - bytes;
            return offset;
        }
        return std::nullopt;
    }

    /// Frees a range that was taken, and merges it with free neighbours.
    void give_back(std::uint64_t offset, std::uint64_t bytes) {
        const auto it = free_.emplace(offset, bytes).first;
        const auto next = std::next(it);
        if (next != free_.end() && it->first + it->second == next->first) {
            it->second += next->second;
            free_.erase(next);
        }
        if (it == free_.begin()) return;
        const auto before = std::prev(it);
        if (before->first + before->second == it->first) {
            before->second += it->second;
            free_.erase(it);
        }
    }

private:
    std::map<std::uint64_t, std::uint64_t> free_;  // offset -> bytes
};

}  // namespace glift::detail
