// Plain zeroed bytes, aligned to cache lines.
#pragma once

#include "../objects.h"

#include <atomic>

namespace glift::detail {

struct HostCounters {
    std::atomic<std::uint64_t> passes{0}, memories{0}, bytes{0};
};

class HostMemoryObject final : public MemoryObject {
public:
    /// Throws out_of_memory.
    HostMemoryObject(std::shared_ptr<DeviceObject> device, const MemoryDescription& description,
                     HostCounters& counters);
    ~HostMemoryObject() override;

    std::byte* data() const { return data_; }
    HostMemory view() const {
        const MemoryDescription& d = description();
        return {data_, d.bytes, d.extent, d.format, d.mips};
    }

private:
    void* storage_ = nullptr;
    std::byte* data_ = nullptr;
    HostCounters& counters_;
};

inline HostMemoryObject& host_memory(const Memory& memory) { return static_cast<HostMemoryObject&>(*memory.object()); }

}  // namespace glift::detail
