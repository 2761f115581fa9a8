#include "instance.h"

#include "../environment.h"

#include <glift/error.h>

#include <cstdlib>
#include <cstring>
#include <utility>

namespace glift::detail {

namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

// The value of the environment variable VK_LAYER_ENABLES by which the validation layer checks hazards between
// submissions. Version 1.3.239 of the layer has no other way to enable that.
constexpr const char* queue_submit_checks = "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT:"
                                            "VALIDATION_CHECK_ENABLE_SYNCHRONIZATION_VALIDATION_QUEUE_SUBMIT";

bool wants_validation() { return environment_flag("GLIFT_VALIDATE"); }

template <class Pointer> Function<Pointer> global(PFN_vkGetInstanceProcAddr entry, const char* name) {
    return Function<Pointer>(entry(VK_NULL_HANDLE, name));
}

void require_version(PFN_vkGetInstanceProcAddr entry) {
    std::uint32_t version = VK_API_VERSION_1_0;
    const auto enumerate = global<PFN_vkEnumerateInstanceVersion>(entry, "vkEnumerateInstanceVersion");
    if (enumerate) check_result(enumerate(&version), "vkEnumerateInstanceVersion");
    if (version >= VK_API_VERSION_1_3) return;
    throw Error(ErrorCode::unsupported_version, "the Vulkan loader is too old", "Device::open",
                "it supports Vulkan " + std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
                    std::to_string(VK_API_VERSION_MINOR(version)) + ", Glift needs 1.3",
                "update the loader (Debian 12: apt install libvulkan1)");
}

void require_layer(PFN_vkGetInstanceProcAddr entry) {
    const auto enumerate = global<PFN_vkEnumerateInstanceLayerProperties>(entry, "vkEnumerateInstanceLayerProperties");
    const auto layers = listed<VkLayerProperties>("vkEnumerateInstanceLayerProperties", enumerate);
    for (const VkLayerProperties& layer : layers) {
        if (std::strcmp(layer.layerName, validation_layer) == 0) return;
    }
    throw Error(ErrorCode::missing_layer, "the Vulkan validation layer is not installed", "Device::open",
                "GLIFT_VALIDATE is set",
                "install it (Debian: apt install vulkan-validationlayers), or unset GLIFT_VALIDATE");
}

bool has_extension(PFN_vkGetInstanceProcAddr entry, const char* name) {
    const auto enumerate =
        global<PFN_vkEnumerateInstanceExtensionProperties>(entry, "vkEnumerateInstanceExtensionProperties");
    const auto extensions = listed<VkExtensionProperties>(
        "vkEnumerateInstanceExtensionProperties",
        [&](std::uint32_t* count, VkExtensionProperties* values) { return enumerate(nullptr, count, values); });
    for (const VkExtensionProperties& extension : extensions) {
        if (std::strcmp(extension.extensionName, name) == 0) return true;
    }
    return false;
}

/// The user's extensions, and VK_EXT_debug_utils (names, messages) if it is there. Throws missing_feature if one of the
/// user's is not there.
std::vector<const char*> usable_extensions(PFN_vkGetInstanceProcAddr entry, std::span<const std::string> wanted) {
    std::vector<const char*> names;
    for (const std::string& name : wanted) {
        if (!has_extension(entry, name.c_str())) {
            throw Error(ErrorCode::missing_feature, "Vulkan lacks an extension that was asked for",
                        "glift::vulkan::open", "no driver on this machine has " + name,
                        "install a driver that has it (Debian, on the CPU: apt install mesa-vulkan-drivers)");
        }
        names.push_back(name.c_str());
    }
    if (has_extension(entry, VK_EXT_DEBUG_UTILS_EXTENSION_NAME)) names.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    return names;
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* instance) {
    static_cast<Instance*>(instance)->note(data->pMessage);
    return VK_FALSE;
}

// Messages are filtered by type as well as by severity, since images in the layout GENERAL, which Glift uses on
// purpose, raise performance warnings.
VkDebugUtilsMessengerCreateInfoEXT messenger_info(Instance* instance) {
    return {.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
            .messageSeverity =
                VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
            .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
            .pfnUserCallback = on_message,
            .pUserData = instance};
}

class ScopedLayerEnables {
public:
    explicit ScopedLayerEnables(bool wanted) : set_(wanted && !std::getenv("VK_LAYER_ENABLES")) {
        if (set_) setenv("VK_LAYER_ENABLES", queue_submit_checks, 1);
    }
    ~ScopedLayerEnables() {
        if (set_) unsetenv("VK_LAYER_ENABLES");
    }

private:
    bool set_;
};

[[noreturn]] void throw_no_instance(VkResult result) {
    throw Error(ErrorCode::no_device, "there is no Vulkan driver on this machine", "Device::open, vkCreateInstance",
                result_text(result),
                "install a driver (Debian, on the CPU: apt install mesa-vulkan-drivers), look at VK_DRIVER_FILES and "
                "VK_ICD_FILENAMES, or run on the host device: Device::open(\"host\") or GLIFT_DEVICE=host");
}

}  // namespace

std::unique_ptr<Instance> Instance::create(std::span<const std::string> extensions) {
    std::unique_ptr<Instance> instance(new Instance);
    instance->entry_ = load_vulkan();
    instance->owned_ = true;
    require_version(instance->entry_);
    const bool validate = wants_validation();
    if (validate) require_layer(instance->entry_);
    const std::vector<const char*> names = usable_extensions(instance->entry_, extensions);

    const VkApplicationInfo application = {
        .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .pEngineName = "glift", .apiVersion = VK_API_VERSION_1_3};
    const VkValidationFeatureEnableEXT checks[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT validation = {.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                          .enabledValidationFeatureCount = 1,
                                          .pEnabledValidationFeatures = checks};
    const VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                       .pNext = validate ? &validation : nullptr,
                                       .pApplicationInfo = &application,
                                       .enabledLayerCount = validate ? 1u : 0u,
                                       .ppEnabledLayerNames = &validation_layer,
                                       .enabledExtensionCount = static_cast<std::uint32_t>(names.size()),
                                       .ppEnabledExtensionNames = names.data()};
    const ScopedLayerEnables enables(validate);
    const auto create = global<PFN_vkCreateInstance>(instance->entry_, "vkCreateInstance");
    const VkResult result = create(&info, nullptr, &instance->handle_);
    if (result != VK_SUCCESS) throw_no_instance(result);
    instance->table_ = load_instance_table(instance->entry_, instance->handle_);
    if (validate) instance->create_messenger();
    return instance;
}

std::unique_ptr<Instance> Instance::adopt(VkInstance handle, PFN_vkGetInstanceProcAddr get) {
    std::unique_ptr<Instance> instance(new Instance);
    instance->entry_ = get ? get : load_vulkan();
    instance->handle_ = handle;
    instance->table_ = load_instance_table(instance->entry_, handle);
    if (wants_validation()) instance->create_messenger();
    return instance;
}

void Instance::create_messenger() {
    if (!table_.vkCreateDebugUtilsMessengerEXT) return;
    const auto info = messenger_info(this);
    if (table_.vkCreateDebugUtilsMessengerEXT(handle_, &info, nullptr, &messenger_) != VK_SUCCESS) {
        messenger_ = VK_NULL_HANDLE;
    }
}

Instance::~Instance() {
    if (messenger_) table_.vkDestroyDebugUtilsMessengerEXT(handle_, messenger_, nullptr);
    if (owned_ && handle_) table_.vkDestroyInstance(handle_, nullptr);
}

std::vector<VkPhysicalDevice> Instance::physical_devices() const {
    return listed<VkPhysicalDevice>("vkEnumeratePhysicalDevices", [&](std::uint32_t* count, VkPhysicalDevice* devices) {
        const VkResult result = table_.vkEnumeratePhysicalDevices(handle_, count, devices);
        if (result < 0) throw_no_instance(result);
        return result;
    });
}

void Instance::note(std::string message) {
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
}

std::vector<std::string> Instance::take_messages() {
    const std::lock_guard lock(mutex_);
    return std::exchange(messages_, {});
}

}  // namespace glift::detail
