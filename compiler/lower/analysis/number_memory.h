// The tables of value numbering (number.h). Every pass numbers a body anew and reuses the tables: each entry has a time
// stamp, by which old ones count as absent, so that nothing has to be cleared.
#pragma once

#include "ir/ir.h"
#include "lower/build/node_map.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gliftc::lower {

/// A hash, of 128 bits, of the shape of a node: its operation, type and constants, the version of the local or memory
/// that it reads, and the value numbers of its operands. Equal hashes are taken to mean equal shapes.
struct ShapeKey {
    std::uint64_t high = 0, low = 0;
    bool operator==(const ShapeKey&) const = default;
    void mix(std::uint64_t word) {
        low = (low ^ word) * 0x9e3779b97f4a7c15ull;
        low ^= low >> 32;
        high = (high + word + 0x7f4a7c15u) * 0xd6e8feb86659fd93ull;
        high ^= high >> 29;
    }
};

class NumberMemory {
public:
    explicit NumberMemory(ir::ExprId first) : known_(first) {}

    /// Forgets everything.
    void restart() {
        start_ = ++time_;
        ++time_;  // so that time_ differs from start_, which marks numbers that no change makes invalid
        shapes_ = 0;
    }
    /// Says that a local or a memory has changed: forgets the numbers of nodes whose values may change.
    void note_change() { ++time_; }

    /// The number of a shape. 0: it has none yet, and the caller must set one.
    std::uint32_t& number_of(const ShapeKey& key) {
        if (++shapes_ * 2 > slots_.size()) grow();
        Slot& slot = slots_[place(key)];
        if (slot.start == start_) --shapes_;
        else slot = {key, 0, start_};
        return slot.number;
    }

    /// The number of a node, if it is known and still valid; or 0.
    std::uint32_t known(ir::ExprId id) const {
        const Known* found = known_.find(id);
        return found != nullptr && (found->time == start_ || found->time == time_) ? found->number : 0;
    }
    void learn(ir::ExprId id, std::uint32_t number, bool is_fixed) { known_[id] = {number, is_fixed ? start_ : time_}; }

private:
    struct Slot {
        ShapeKey key;
        std::uint32_t number = 0, start = 0;
    };
    struct Known {
        std::uint32_t number = 0, time = 0;
    };

    /// The index of the key's slot, or of the free slot where it belongs. Open addressing with linear probing; the
    /// table is never more than half full, so that there is a free slot.
    std::size_t place(const ShapeKey& key) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = key.low & mask;
        while (slots_[at].start == start_ && slots_[at].key != key) at = (at + 1) & mask;
        return at;
    }
    void grow() {
        std::vector<Slot> before(std::max<std::size_t>(512, slots_.size() * 2));
        before.swap(slots_);
        for (const Slot& slot : before)
            if (slot.start == start_) slots_[place(slot.key)] = slot;
    }

    std::vector<Slot> slots_;
    std::size_t shapes_ = 0;
    NodeMap<ir::ExprId, Known> known_;
    std::uint32_t time_ = 0;   ///< increased by each change and restart
    std::uint32_t start_ = 0;  ///< the time given to entries that stay valid until the next restart
};

}  // namespace gliftc::lower
