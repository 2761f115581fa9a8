// Memory of the host device: plain bytes, which start as zeros and are aligned to cache lines.
#pragma once

#include "../environment.h"
#include "../image_layout.h"
#include "../objects.h"

#include <atomic>

namespace glift::detail {

struct HostCounters {
    std::atomic<std::uint64_t> passes{0}, memories{0}, bytes{0};
    const std::uint64_t limit = memory_limit();  ///< of `bytes`
};

/// The storage of one memory, or of the temporaries that share it.
class HostStorage {
public:
    /// Throws out_of_memory, naming the memory described.
    HostStorage(std::uint64_t bytes, const MemoryDescription& description, HostCounters& counters);
    ~HostStorage();
    HostStorage(const HostStorage&) = delete;
    HostStorage& operator=(const HostStorage&) = delete;

    std::byte* data() const { return data_; }

private:
    std::uint64_t bytes_;
    void* allocated_ = nullptr;
    std::byte* data_ = nullptr;
    HostCounters& counters_;
};

class HostMemoryObject final : public MemoryObject {
public:
    HostMemoryObject(std::shared_ptr<DeviceObject> device, const MemoryDescription& description,
                     std::shared_ptr<HostStorage> storage, std::uint64_t offset, HostCounters& counters);
    ~HostMemoryObject() override;

    std::byte* data() const { return data_; }
    HostMemory view() const {
        const MemoryDescription& d = description();
        if (d.kind == MemoryKind::imagecube)
            return {data_, d.bytes, {d.extent[0], d.extent[1], face_count(d)}, d.format, d.mips, true};
        return {data_, d.bytes, d.extent, d.format, d.mips, d.kind == MemoryKind::image2darray};
    }
    std::shared_ptr<MemoryObject> part(const MemoryDescription& description, const Texels& texels) override;

private:
    HostMemoryObject(const std::shared_ptr<HostMemoryObject>& whole, const MemoryDescription& description,
                     const Texels& texels);

    std::shared_ptr<HostStorage> storage_;
    std::byte* data_;
    HostCounters& counters_;
};

inline HostMemoryObject& host_memory(const Memory& memory) { return static_cast<HostMemoryObject&>(*memory.object()); }

}  // namespace glift::detail
