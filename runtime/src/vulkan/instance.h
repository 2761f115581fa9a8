// A Vulkan instance, created or adopted, and the messages of its validation layer.
#pragma once

#include "loader.h"

#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace glift::detail {

class Instance {
public:
    /// Creates an instance with the user's extensions, and with the validation layer if GLIFT_VALIDATE=1. Throws
    /// no_loader, unsupported_version, missing_layer, missing_feature, no_device; wrong_argument if GLIFT_VALIDATE is
    /// not 0, 1 or empty.
    static std::unique_ptr<Instance> create(std::span<const std::string> extensions);
    static std::unique_ptr<Instance> adopt(VkInstance instance, PFN_vkGetInstanceProcAddr get);
    ~Instance();
    Instance(const Instance&) = delete;

    VkInstance handle() const { return handle_; }
    const InstanceTable& vk() const { return table_; }
    PFN_vkGetInstanceProcAddr entry() const { return entry_; }
    std::vector<VkPhysicalDevice> physical_devices() const;
    bool is_validated() const { return messenger_ != VK_NULL_HANDLE; }
    std::vector<std::string> take_messages();
    void note(std::string message);

private:
    Instance() = default;
    void create_messenger();

    PFN_vkGetInstanceProcAddr entry_ = nullptr;
    VkInstance handle_ = VK_NULL_HANDLE;
    InstanceTable table_;
    bool owned_ = false;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    std::mutex mutex_;
    std::vector<std::string> messages_;
};

}  // namespace glift::detail
