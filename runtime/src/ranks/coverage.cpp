#include "coverage.h"

#include "../objects.h"

#include <algorithm>

namespace glift::detail {

Coverage* Coverages::find(const Memory& memory) {
    const auto at = coverages_.find(memory.object());
    if (at == coverages_.end()) return nullptr;
    if (at->second.memory.lock().get() == memory.object()) return &at->second;
    coverages_.erase(at);  // of a memory that is gone, in whose place there is this one
    return nullptr;
}

Coverage& Coverages::set(const Memory& memory, Coverage coverage) {
    if (coverages_.size() > 256) std::erase_if(coverages_, [](const auto& one) { return one.second.memory.expired(); });
    coverage.memory = memory.share();
    coverage.number = next_number_++;
    return coverages_[memory.object()] = std::move(coverage);
}

std::vector<std::pair<Memory, Coverage*>> Coverages::of(const Space& space) {
    std::vector<std::pair<Memory, Coverage*>> found;
    for (auto& [object, coverage] : coverages_)
        if (coverage.space.get() == &space)
            if (auto memory = coverage.memory.lock()) found.emplace_back(Memory(std::move(memory)), &coverage);
    std::ranges::sort(found, {}, [](const auto& one) { return one.second->number; });
    return found;
}

}  // namespace glift::detail
