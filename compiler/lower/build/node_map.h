// A map from nodes to values, for lowering one pass. Most nodes are made by that lowering: they have consecutive ids,
// and their values are in an array. Older nodes, which the program has and of which a pass uses few, are in a hash map.
#pragma once

#include "base/flat_map.h"

#include <algorithm>

namespace gliftc::lower {

/// Lowering a kernel makes about a hundred maps of similar size one after the other: each reuses the array of an
/// earlier map of its thread. An entry is valid if its `time` is the array's, which each new map and each clear()
/// increases, so that no entries have to be reset.
template <class Id, class Value> class NodeMap {
public:
    /// `first`: nodes with smaller ids are older than the lowering.
    explicit NodeMap(Id first) : first_(first.index) {
        std::vector<Array>& spare = spare_arrays();
        if (spare.empty()) spare.emplace_back();
        own_ = std::move(spare.back());
        spare.pop_back();
        ++own_.time;
    }
    NodeMap(const NodeMap&) = delete;
    NodeMap& operator=(const NodeMap&) = delete;
    ~NodeMap() { spare_arrays().push_back(std::move(own_)); }

    Value* find(Id id) {
        if (id.index < first_) return older_.find(id);
        const std::uint32_t at = id.index - first_;
        return at < own_.slots.size() && own_.slots[at].time == own_.time ? &own_.slots[at].value : nullptr;
    }
    const Value* find(Id id) const { return const_cast<NodeMap*>(this)->find(id); }
    bool contains(Id id) const { return find(id) != nullptr; }

    /// The value of the node, and whether it was inserted by this call.
    std::pair<Value*, bool> emplace(Id id, Value value) {
        if (id.index < first_) return older_.emplace(id, std::move(value));
        const std::uint32_t at = id.index - first_;
        if (at >= own_.slots.size()) own_.slots.resize(std::max<std::size_t>(at + 64, own_.slots.size() * 2));
        Slot& slot = own_.slots[at];
        const bool is_new = slot.time != own_.time;
        if (is_new) slot = {std::move(value), own_.time};
        return {&slot.value, is_new};
    }
    Value& operator[](Id id) { return *emplace(id, Value{}).first; }
    void clear() {
        ++own_.time;
        older_.clear();
    }

private:
    struct Slot {
        Value value{};
        std::uint32_t time = 0;
    };
    struct Array {
        std::vector<Slot> slots;
        std::uint32_t time = 0;
    };
    static std::vector<Array>& spare_arrays() {
        thread_local std::vector<Array> spare;
        return spare;
    }

    std::uint32_t first_;
    Array own_;
    FlatMap<Id, Value> older_;
};

}  // namespace gliftc::lower
