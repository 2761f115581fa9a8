// Values by node, where most nodes are the pass's own: these have consecutive ids and their values lie in one array.
// Nodes of the program, which are older and few in a pass, are in a hash map.
#pragma once

#include "lower/flat_map.h"

#include <algorithm>
#include <optional>

namespace gliftc::lower {

template <class Id, class Value> class NodeMap {
public:
    /// `first` is the smallest id that the pass made.
    explicit NodeMap(Id first) : first_(first.index) {}

    Value* find(Id id) {
        if (id.index < first_) return older_.find(id);
        const std::uint32_t at = id.index - first_;
        return at < own_.size() && own_[at] ? &*own_[at] : nullptr;
    }
    const Value* find(Id id) const { return const_cast<NodeMap*>(this)->find(id); }
    bool contains(Id id) const { return find(id) != nullptr; }

    /// The value of the node and whether it was put there now.
    std::pair<Value*, bool> emplace(Id id, Value value) {
        if (id.index < first_) return older_.emplace(id, std::move(value));
        const std::uint32_t at = id.index - first_;
        if (at >= own_.size()) own_.resize(std::max<std::size_t>(at + 64, own_.size() * 2));
        const bool is_new = !own_[at];
        if (is_new) own_[at] = std::move(value);
        return {&*own_[at], is_new};
    }
    Value& operator[](Id id) { return *emplace(id, Value{}).first; }
    void clear() {
        own_.clear();
        older_.clear();
    }

private:
    std::uint32_t first_;
    std::vector<std::optional<Value>> own_;
    FlatMap<Id, Value> older_;
};

}  // namespace gliftc::lower
