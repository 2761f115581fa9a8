#include "loader.h"

#include <glift/error.h>

#include <cstdlib>
#include <dlfcn.h>
#include <string>

namespace glift::detail {

PFN_vkGetInstanceProcAddr load_vulkan() {
    const char* named = std::getenv("GLIFT_VULKAN_LOADER");
    const char* name = named && *named ? named : "libvulkan.so.1";
    // Never closed: drivers and layers leave threads and exit handlers behind.
    void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    void* entry = library ? dlsym(library, "vkGetInstanceProcAddr") : nullptr;
    if (!entry) {
        const char* reason = dlerror();
        const bool is_named = name == named;
        const std::string remedy = is_named ? "name another library in GLIFT_VULKAN_LOADER, or unset it"
                                            : "install it (Debian: apt install libvulkan1 mesa-vulkan-drivers)";
        throw Error(ErrorCode::no_loader,
                    is_named ? "GLIFT_VULKAN_LOADER names no Vulkan loader"
                             : "there is no Vulkan loader on this machine",
                    std::string("Device::open, ") + name, reason ? reason : "it has no vkGetInstanceProcAddr",
                    remedy + ", or run on the host device: Device::open(\"host\") or GLIFT_DEVICE=host");
    }
    return reinterpret_cast<PFN_vkGetInstanceProcAddr>(entry);
}

namespace {

/// A function of Vulkan's core. Loaders have none that is newer than the version that the instance was made for.
PFN_vkVoidFunction required(PFN_vkVoidFunction found, const char* name) {
    if (found) return found;
    throw Error(ErrorCode::unsupported_version, "the instance was made for a Vulkan that is too old", name,
                "Glift needs the functions of Vulkan 1.3, of which this one is missing",
                "make the instance with VkApplicationInfo::apiVersion = VK_API_VERSION_1_3");
}

}  // namespace

InstanceTable load_instance_table(PFN_vkGetInstanceProcAddr get, VkInstance instance) {
    InstanceTable table;
#define GLIFT_LOAD(name) table.name = Function<PFN_##name>(required(get(instance, #name), #name));
#define GLIFT_LOAD_OPTIONAL(name) table.name = Function<PFN_##name>(get(instance, #name));
    GLIFT_INSTANCE_FUNCTIONS(GLIFT_LOAD)
    GLIFT_INSTANCE_EXTENSION_FUNCTIONS(GLIFT_LOAD_OPTIONAL)
#undef GLIFT_LOAD
#undef GLIFT_LOAD_OPTIONAL
    return table;
}

DeviceTable load_device_table(const InstanceTable& instance, VkDevice device) {
    DeviceTable table;
#define GLIFT_LOAD(name)                                                                                               \
    table.name = Function<PFN_##name>(required(instance.vkGetDeviceProcAddr(device, #name), #name));
#define GLIFT_LOAD_OPTIONAL(name) table.name = Function<PFN_##name>(instance.vkGetDeviceProcAddr(device, #name));
    GLIFT_DEVICE_FUNCTIONS(GLIFT_LOAD)
    GLIFT_DEVICE_EXTENSION_FUNCTIONS(GLIFT_LOAD_OPTIONAL)
#undef GLIFT_LOAD
#undef GLIFT_LOAD_OPTIONAL
    return table;
}

void check_result(VkResult result, const char* call) {
    if (result >= 0) return;
    const bool no_memory = result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY;
    throw Error(no_memory ? ErrorCode::out_of_memory : ErrorCode::vulkan, "a Vulkan call failed",
                std::string("Device::open, ") + call, result_text(result),
                "look at the driver's installation (vulkaninfo), or run on the host device: Device::open(\"host\") or "
                "GLIFT_DEVICE=host");
}

std::string result_text(VkResult result) {
    switch (static_cast<int>(result)) {
    case VK_SUCCESS: return "VK_SUCCESS";
    case VK_NOT_READY: return "VK_NOT_READY";
    case VK_TIMEOUT: return "VK_TIMEOUT";
    case VK_INCOMPLETE: return "VK_INCOMPLETE";
    case VK_ERROR_OUT_OF_HOST_MEMORY: return "VK_ERROR_OUT_OF_HOST_MEMORY";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY: return "VK_ERROR_OUT_OF_DEVICE_MEMORY";
    case VK_ERROR_INITIALIZATION_FAILED: return "VK_ERROR_INITIALIZATION_FAILED";
    case VK_ERROR_DEVICE_LOST: return "VK_ERROR_DEVICE_LOST";
    case VK_ERROR_MEMORY_MAP_FAILED: return "VK_ERROR_MEMORY_MAP_FAILED";
    case VK_ERROR_LAYER_NOT_PRESENT: return "VK_ERROR_LAYER_NOT_PRESENT";
    case VK_ERROR_EXTENSION_NOT_PRESENT: return "VK_ERROR_EXTENSION_NOT_PRESENT";
    case VK_ERROR_FEATURE_NOT_PRESENT: return "VK_ERROR_FEATURE_NOT_PRESENT";
    case VK_ERROR_INCOMPATIBLE_DRIVER: return "VK_ERROR_INCOMPATIBLE_DRIVER";
    case VK_ERROR_TOO_MANY_OBJECTS: return "VK_ERROR_TOO_MANY_OBJECTS";
    case VK_ERROR_FORMAT_NOT_SUPPORTED: return "VK_ERROR_FORMAT_NOT_SUPPORTED";
    case VK_ERROR_OUT_OF_POOL_MEMORY: return "VK_ERROR_OUT_OF_POOL_MEMORY";
    case VK_ERROR_FRAGMENTATION: return "VK_ERROR_FRAGMENTATION";
    case VK_ERROR_INVALID_SHADER_NV: return "VK_ERROR_INVALID_SHADER_NV";
    case VK_ERROR_UNKNOWN: return "VK_ERROR_UNKNOWN";
    }
    return "VkResult " + std::to_string(static_cast<int>(result));
}

}  // namespace glift::detail
