// A logical device, created or adopted: functions, queue, limits, and errors of failed calls.
#pragma once

#include "../objects.h"
#include "features.h"
#include "vulkan/spirv/float_controls.h"

#include <atomic>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace glift::detail {

class Context {
public:
    /// Extensions that the user wants, beside those that Glift uses.
    struct Wanted {
        std::vector<std::string> instance, device;
    };
    static std::unique_ptr<Context> open(std::string_view which, const Wanted& wanted);
    struct Adopted {
        VkInstance instance;
        VkPhysicalDevice physical;
        VkDevice device;
        VkQueue queue;
        std::uint32_t queue_family;
        std::vector<const char*> extensions;
        PFN_vkGetInstanceProcAddr entry;
    };
    static std::unique_ptr<Context> adopt(const Adopted& objects);
    ~Context();
    Context(const Context&) = delete;

    /// Throws if the call failed. `call` names the Vulkan function.
    void check(VkResult result, const char* call) {
        if (result < 0) fail(result, call);
    }
    void require_not_lost() {
        if (lost) fail(VK_ERROR_DEVICE_LOST, "an earlier call");
    }
    [[noreturn]] void fail(VkResult result, const char* call);

    DrawLimits draw_limits() const;

    /// Names a Vulkan object for debuggers and validation messages.
    void set_name(VkObjectType type, std::uint64_t handle, const char* name) const;

    std::unique_ptr<Instance> instance;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t queue_family = 0;
    VkQueue transfer_queue = VK_NULL_HANDLE;  ///< of a family that only copies; null: there is none
    std::uint32_t transfer_family = 0;
    VkDeviceSize host_import_alignment = 0;  ///< of memory of the host that is imported; 0: none can be
    /// Memory of the host is imported by its pages, which a few systems have larger than 4 KiB.
    bool can_link() const { return transfer_queue && host_import_alignment && host_import_alignment <= 4096; }
    std::uint32_t timestamp_bits = 0;
    bool owned = false;  ///< opened by Glift, else adopted: `device` is then the program's
    /// Whether the user's program submits to the queue, too: always for an adopted device; for one that Glift opened,
    /// from the first call of glift::vulkan::objects on.
    bool shares_queue = false;
    DeviceTable vk;
    DeviceProperties properties;
    SubgroupSizes subgroups;
    bool has_labels = false;  ///< a debugger or a layer looks at the device: passes get labels
    bool can_draw = false;    ///< the queue's family has graphics
    VkPhysicalDeviceProperties core = {};
    VkPhysicalDeviceMemoryProperties memory = {};
    std::uint32_t max_push_descriptors = 0;
    std::uint64_t max_piece_bytes = 0;  ///< largest allocation; larger buffers need several, and sparse binding
    FloatControls float_controls;
    bool hides_loop_ends = false;         ///< the driver loses rounds of loops that end at zero: see hidden_limits.h
    bool separates_texels = false;        ///< the driver mixes components of integer texels up: see separate_texels.h
    std::vector<const char*> extensions;  ///< names of the device's enabled extensions; point into names_
    std::atomic<bool> lost{false};

private:
    Context() = default;
    void set_extensions(std::span<const char* const> own, std::span<const std::string> wanted = {});
    std::vector<std::string> names_;  ///< copies, since the user's strings may be gone before the device
    void make_device(const FeatureChain& features);
    void read_limits(const FeatureChain& features);
    bool is_looked_at() const;
};

}  // namespace glift::detail
