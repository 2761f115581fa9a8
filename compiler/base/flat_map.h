// A hash map from ids to small values, in one array, without an allocation per entry. It must be fast, since lowering
// looks up every node several times.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace gliftc::lower {

/// Keys are Ids or numbers below 2^32 - 1.
template <class Key, class Value> class FlatMap {
public:
    Value* find(Key key) {
        if (slots_.empty()) return nullptr;
        Slot& slot = slots_[place(word(key))];
        return slot.key == empty ? nullptr : &slot.value;
    }
    const Value* find(Key key) const { return const_cast<FlatMap*>(this)->find(key); }
    bool contains(Key key) const { return find(key) != nullptr; }

    /// The value at the key, and whether it was inserted by this call.
    std::pair<Value*, bool> emplace(Key key, Value value) {
        if ((count_ + 1) * 2 > slots_.size()) grow();
        Slot& slot = slots_[place(word(key))];
        if (slot.key != empty) return {&slot.value, false};
        slot.key = word(key);
        slot.value = std::move(value);
        ++count_;
        return {&slot.value, true};
    }
    Value& operator[](Key key) { return *emplace(key, Value{}).first; }
    /// Calls visit(Key, Value&) for each entry, in no particular order.
    template <class Visit> void for_each(Visit&& visit) {
        for (Slot& slot : slots_)
            if (slot.key != empty) visit(Key{slot.key}, slot.value);
    }
    void clear() {
        slots_.clear();
        count_ = 0;
    }

private:
    static constexpr std::uint32_t empty = 0xffffffffu;
    struct Slot {
        std::uint32_t key = empty;
        Value value{};
    };

    static std::uint32_t word(std::uint32_t key) { return key; }
    template <class Id> static std::uint32_t word(Id id) { return id.index; }
    std::size_t place(std::uint32_t key) const {
        std::size_t mask = slots_.size() - 1;
        std::size_t at = (key * 0x9e3779b1u) & mask;
        while (slots_[at].key != empty && slots_[at].key != key) at = (at + 1) & mask;
        return at;
    }
    void grow() {
        std::vector<Slot> old(slots_.empty() ? 16 : slots_.size() * 2);
        std::swap(old, slots_);
        for (Slot& slot : old)
            if (slot.key != empty) slots_[place(slot.key)] = std::move(slot);
    }

    std::vector<Slot> slots_;
    std::size_t count_ = 0;
};

}  // namespace gliftc::lower
