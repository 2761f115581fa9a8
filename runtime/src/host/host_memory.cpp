#include "host_memory.h"

#include "../environment.h"
#include "../text.h"

#include <glift/error.h>

#include <cstdlib>

namespace glift::detail {

namespace {

constexpr std::uint64_t alignment = 64;

}  // namespace

HostStorage::HostStorage(std::uint64_t bytes, const MemoryDescription& description, HostCounters& counters)
    : bytes_(bytes), counters_(counters) {
    // calloc gives large blocks as untouched zero pages, which aligned allocation followed by memset would touch.
    const bool fits = bytes < UINT64_MAX - 2 * alignment && counters_.bytes.load() + bytes <= memory_limit();
    if (fits) allocated_ = std::calloc(1, bytes + 2 * alignment);
    if (!allocated_) {
        throw Error(ErrorCode::out_of_memory, "the host has no memory left for a structure", memory_text(description),
                    size_text(bytes) + " asked for, " + size_text(counters_.bytes.load()) + " in use by Glift",
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
