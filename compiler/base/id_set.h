// A set of ids, such as the nodes that a walk has visited. Most sets are small: up to 16 ids are stored inline, the ids
// of a larger set on the heap.
#pragma once

#include "base/arena.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gliftc {

/// A hash table with open addressing, never more than half full.
template <class T> class IdSet {
public:
    IdSet() { clear(); }
    IdSet(const IdSet&) = delete;
    IdSet& operator=(const IdSet&) = delete;

    /// Adds the id; true if it was not in the set before.
    bool insert(Id<T> id) {
        std::uint32_t& slot = slots()[place(id.index)];
        if (slot != empty) return false;
        slot = id.index;
        if (++count_ * 2 > mask_ + 1) grow();
        return true;
    }
    void clear() {
        std::fill(inside_, inside_ + inside_size, empty);
        outside_.clear();
        mask_ = inside_size - 1;
        count_ = 0;
    }
    bool contains(Id<T> id) const { return slots()[place(id.index)] != empty; }

private:
    static constexpr std::uint32_t empty = Id<T>::none, inside_size = 32;

    std::uint32_t* slots() { return outside_.empty() ? inside_ : outside_.data(); }
    const std::uint32_t* slots() const { return outside_.empty() ? inside_ : outside_.data(); }
    std::uint32_t place(std::uint32_t index) const {
        std::uint32_t at = (index * 0x9e3779b1u) & mask_;
        while (slots()[at] != empty && slots()[at] != index) at = (at + 1) & mask_;
        return at;
    }
    void grow() {
        std::uint32_t size = mask_ + 1;
        std::vector<std::uint32_t> before(slots(), slots() + size);
        outside_.assign(std::size_t{size} * 4, empty);
        mask_ = size * 4 - 1;
        for (std::uint32_t index : before)
            if (index != empty) outside_[place(index)] = index;
    }

    std::uint32_t inside_[inside_size];
    std::vector<std::uint32_t> outside_;
    std::uint32_t mask_ = inside_size - 1, count_ = 0;
};

}  // namespace gliftc
