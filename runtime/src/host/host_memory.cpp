#include "host_memory.h"

#include "../text.h"

#include <glift/error.h>

#include <algorithm>
#include <cstdlib>

namespace glift::detail {

namespace {

constexpr std::uint64_t alignment = 64;

}  // namespace

HostStorage::HostStorage(std::uint64_t bytes, const MemoryDescription& description, HostCounters& counters)
    : bytes_(bytes), counters_(counters) {
    // calloc gives large blocks as untouched zero pages, which aligned allocation followed by memset would touch.
    const std::uint64_t used = counters_.bytes, most = std::min(counters_.limit, UINT64_MAX - 2 * alignment);
    const bool fits = used <= most && bytes <= most - used;
    if (fits) allocated_ = std::calloc(1, bytes + 2 * alignment);
    if (!allocated_) {
        throw Error(ErrorCode::out_of_memory, "the host has no memory left for a structure", memory_text(description),
                    size_text(bytes) + " asked for, " + size_text(used) + " in use by Glift" +
                        (counters_.limit == unlimited ? "" : "; GLIFT_MEMORY_LIMIT is " + size_text(counters_.limit)),
                    "free structures that are no longer used, or make them smaller");
    }
    const auto address = reinterpret_cast<std::uintptr_t>(allocated_);
    data_ = reinterpret_cast<std::byte*>((address + alignment - 1) / alignment * alignment);
    counters_.bytes += bytes;
}

HostStorage::~HostStorage() {
    std::free(allocated_);
    counters_.bytes -= bytes_;
}

HostMemoryObject::HostMemoryObject(std::shared_ptr<DeviceObject> device, const MemoryDescription& description,
                                   std::shared_ptr<HostStorage> storage, std::uint64_t offset, HostCounters& counters)
    : MemoryObject(std::move(device), description), storage_(std::move(storage)), data_(storage_->data() + offset),
      counters_(counters) {
    ++counters_.memories;
}

HostMemoryObject::~HostMemoryObject() { --counters_.memories; }

}  // namespace glift::detail
