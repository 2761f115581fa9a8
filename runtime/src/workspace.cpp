#include "workspace.h"

#include "objects.h"

#include <algorithm>
#include <utility>

namespace glift::detail {

namespace {

constexpr std::uint64_t granularity = 256;  // bytes: temporaries get separate cache lines; gaps are easier to reuse

}  // namespace

Workspace::Place Workspace::take(const StorageNeeds& needs) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t alignment = std::max(needs.alignment, granularity);
    const std::uint64_t bytes = (std::max<std::uint64_t>(needs.bytes, 1) + granularity - 1) / granularity * granularity;
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
        const auto offset = blocks_[block].take(bytes, alignment);
        if (offset) return {block, *offset, bytes, false, std::exchange(was_given_back_, false)};
    }
    blocks_.emplace_back(bytes);
    blocks_.back().take(bytes, 1);
    bytes_ += bytes;
    return {blocks_.size() - 1, 0, bytes, true, false};
}

void Workspace::give_back(const Place& place) {
    const std::lock_guard lock(mutex_);
    blocks_[place.block].give_back(place.offset, place.bytes);
    was_given_back_ = true;
}

void Workspace::add(std::uint64_t bytes) {
    const std::lock_guard lock(mutex_);
    bytes_ += bytes;
}

std::uint64_t Workspace::bytes() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

Memory temporary(std::shared_ptr<MemoryObject> object, std::shared_ptr<Workspace> workspace,
                 const Workspace::Place& place) {
    MemoryObject* const same = object.get();
    const auto release = [object = std::move(object), workspace = std::move(workspace), place](MemoryObject*) {
        workspace->give_back(place);
    };
    return Memory(std::shared_ptr<MemoryObject>(same, release));
}

Memory kept(const Memory& memory) { return Memory(memory.object()->shared_from_this()); }

}  // namespace glift::detail
