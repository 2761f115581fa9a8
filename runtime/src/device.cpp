#include "check.h"
#include "host/host_device.h"
#include "measuring.h"
#include "objects.h"
#include "profile/process_profile.h"
#include "recording_scope.h"
#include "vulkan/vulkan_device.h"

#include <glift/commands.h>
#include <glift/log.h>

#include <atomic>
#include <cstdlib>

namespace glift {

namespace detail {

MemoryObject::MemoryObject(std::shared_ptr<DeviceObject> device, const MemoryDescription& description)
    : device_(std::move(device)), name_(description.name ? description.name : ""), description_(description) {
    description_.name = name_.c_str();
}

}  // namespace detail

const MemoryDescription& Memory::description() const { return object_.in("Memory::description").description(); }

namespace {

/// Logs, once in a process, that Vulkan on the CPU was chosen by default, though the host device would be faster.
void log_cpu_default(const DeviceProperties& properties) {
    static std::atomic<bool> logged{false};
    if (logged.exchange(true)) return;
    detail::log("no GPU was found; Vulkan runs on the CPU: " + properties.name +
                ". The host device is faster there: GLIFT_DEVICE=host, or Device::open(\"host\")");
}

}  // namespace

Device Device::open(std::string_view which) {
    if (which.empty()) {
        if (const char* wanted = std::getenv("GLIFT_DEVICE")) which = wanted;
    }
    const Device device(which == "host" ? detail::open_host_device() : detail::open_vulkan_device(which));
    detail::profile_if_asked(device.share());
    if (which.empty() && device.properties().kind == DeviceKind::cpu) log_cpu_default(device.properties());
    return device;
}

const DeviceProperties& Device::properties() const { return object_.in("Device::properties").properties(); }

Memory Device::allocate(const MemoryDescription& description) const {
    return Memory(object_.in("Device::allocate").allocate(detail::whole_description(description)));
}

Commands Device::commands() const { return Commands(*this); }

void Device::wait() const {
    detail::DeviceObject& device = object_.in("Device::wait");
    detail::require_no_recording(device, "Device::wait");
    device.stream().wait();
}

Statistics Device::statistics() const { return object_.in("Device::statistics").statistics(); }

std::vector<std::string> Device::validation_messages() const {
    return object_.in("Device::validation_messages").validation_messages();
}

MessageSink Device::on_message(MessageSink sink) const {
    return object_.in("Device::on_message").messages().set_sink(std::move(sink));
}

namespace detail {

const std::shared_ptr<DeviceObject>& shared_device(const Device& device, const char* call) {
    if (!device) throw_empty_handle(call);
    return device.share();
}

}  // namespace detail

}  // namespace glift
