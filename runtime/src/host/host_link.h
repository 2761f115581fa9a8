// The host device's link: it copies.
#pragma once

#include "host_memory.h"

#include <cstring>

namespace glift::detail {

class HostAttached final : public AttachedObject {
public:
    explicit HostAttached(std::span<std::byte> bytes_) : bytes(bytes_) {}

    const std::span<std::byte> bytes;
};

class HostLink final : public LinkObject {
public:
    explicit HostLink(DeviceObject& device) : device_(device) {}

    Memory allocate(const MemoryDescription& description) override { return Memory(device_.allocate(description)); }
    std::shared_ptr<AttachedObject> attach(std::span<std::byte> bytes) override {
        return std::make_shared<HostAttached>(bytes);
    }
    void fetch(const Memory& from, AttachedObject& to, std::span<const CopyRegion> regions) override {
        copy(host_memory(from).data(), static_cast<HostAttached&>(to).bytes.data(), regions);
    }
    void put(AttachedObject& from, const Memory& to, std::span<const CopyRegion> regions) override {
        copy(static_cast<HostAttached&>(from).bytes.data(), host_memory(to).data(), regions);
    }

private:
    static void copy(const std::byte* from, std::byte* to, std::span<const CopyRegion> regions) {
        for (const CopyRegion& region : regions) std::memcpy(to + region.to, from + region.from, region.bytes);
    }

    DeviceObject& device_;
};

}  // namespace glift::detail
