#include "host_memory.h"

#include "../image_layout.h"
#include "../machine_memory.h"
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
    // calloc returns large blocks as untouched zero pages; an aligned allocation and memset would touch them all.
    const std::uint64_t used = counters_.bytes, most = std::min(counters_.limit, UINT64_MAX - 2 * alignment);
    const bool fits = used <= most && bytes <= most - used && hold_machine_memory(bytes);
    if (fits) allocated_ = std::calloc(1, bytes + 2 * alignment);
    if (!allocated_) {
        if (fits) release_machine_memory(bytes);
        throw Error(ErrorCode::out_of_memory, "the host has no memory left for a structure", memory_text(description),
                    size_text(bytes) + " asked for; the machine has " + size_text(machine_memory_bytes()) +
                        ", of which " + size_text(used) + " are in use by Glift" +
                        (counters_.limit == unlimited ? "" : "; GLIFT_MEMORY_LIMIT is " + size_text(counters_.limit)),
                    "free structures that are no longer used, or make them smaller");
    }
    const auto address = reinterpret_cast<std::uintptr_t>(allocated_);
    data_ = reinterpret_cast<std::byte*>((address + alignment - 1) / alignment * alignment);
    counters_.bytes += bytes;
}

HostStorage::~HostStorage() {
    std::free(allocated_);
    release_machine_memory(bytes_);
    counters_.bytes -= bytes_;
}

HostMemoryObject::HostMemoryObject(std::shared_ptr<DeviceObject> device, const MemoryDescription& description,
                                   std::shared_ptr<HostStorage> storage, std::uint64_t offset, HostCounters& counters)
    : MemoryObject(std::move(device), description), storage_(std::move(storage)), data_(storage_->data() + offset),
      counters_(counters) {
    ++counters_.memories;
}

HostMemoryObject::HostMemoryObject(const std::shared_ptr<HostMemoryObject>& whole, const MemoryDescription& description,
                                   const Texels& texels)
    : MemoryObject(whole, description, texels), storage_(whole->storage_),
      data_(whole->data_ + mip_offset(whole->description(), texels.mip) +
            texels.layer * face_bytes(whole->description(), texels.mip)),
      counters_(whole->counters_) {
    ++counters_.memories;
}

HostMemoryObject::~HostMemoryObject() { --counters_.memories; }

std::shared_ptr<MemoryObject> HostMemoryObject::part(const MemoryDescription& description, const Texels& texels) {
    const auto whole = std::static_pointer_cast<HostMemoryObject>(shared_from_this());
    return std::shared_ptr<MemoryObject>(new HostMemoryObject(whole, description, texels));
}

}  // namespace glift::detail
