// The ends of commands, and gates, of a Vulkan device.
#pragma once

#include "objects.h"
#include "timeline.h"

namespace glift::detail {

class VulkanPoint final : public PointObject {
public:
    VulkanPoint(std::shared_ptr<DeviceObject> device, Timeline& timeline, std::uint64_t value)
        : device_(std::move(device)), timeline_(timeline), value_(value) {}

    void wait() override { timeline_.poll(value_); }

private:
    std::shared_ptr<DeviceObject> device_;  // owns the timeline
    Timeline& timeline_;
    std::uint64_t value_;
};

class VulkanGate final : public GateObject {
public:
    VulkanGate(std::shared_ptr<DeviceObject> device, Timeline& timeline, std::uint64_t number)
        : device_(std::move(device)), timeline_(timeline), number_(number) {}
    ~VulkanGate() override { open(); }

    void open() override {
        if (!is_open_.exchange(true)) timeline_.open_gate(number_);
    }

private:
    std::shared_ptr<DeviceObject> device_;  // owns the timeline
    Timeline& timeline_;
    std::uint64_t number_;
    std::atomic<bool> is_open_{false};
};

}  // namespace glift::detail
