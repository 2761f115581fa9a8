#include "select.h"

#include "features.h"

#include <glift/error.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace glift::detail {

namespace {

struct Candidate {
    VkPhysicalDevice physical;
    VkPhysicalDeviceProperties properties;
    bool usable;
};

// GPUs before CPUs; discrete GPUs first.
int rank(VkPhysicalDeviceType type) {
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return 4;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return 3;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return 2;
    case VK_PHYSICAL_DEVICE_TYPE_OTHER: return 1;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
    case VK_PHYSICAL_DEVICE_TYPE_MAX_ENUM: return 0;
    }
    return 0;
}

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return std::tolower(c); });
    return result;
}

/// `NAME` or `NAME:INDEX`: of the devices that match the name, best first, the one with this index.
struct Wanted {
    std::string name;
    std::size_t index = 0;
};

Wanted parse_wanted(std::string_view which) {
    Wanted wanted{lower(which)};
    const std::size_t colon = which.rfind(':');
    if (colon == std::string_view::npos) return wanted;
    const std::string_view digits = which.substr(colon + 1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), wanted.index);
    if (error != std::errc{} || end != digits.data() + digits.size()) return {lower(which)};
    wanted.name.resize(colon);
    return wanted;
}

bool matches(const Candidate& candidate, const std::string& which) {
    const bool cpu = candidate.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    if (which.empty()) return true;
    if (which == "gpu") return !cpu;
    const std::string name = lower(candidate.properties.deviceName);
    if (which == "lavapipe") return name.find("llvmpipe") != std::string::npos;
    return name.find(which) != std::string::npos;
}

void require_extensions(const Instance& instance, const Candidate& candidate, std::span<const std::string> extensions) {
    const std::string names = lacking_extensions(instance, candidate.physical, extensions);
    if (names.empty()) return;
    throw Error(ErrorCode::missing_feature, "the device lacks an extension that was asked for",
                candidate.properties.deviceName, "missing: " + names,
                "choose another device, with GLIFT_DEVICE=lavapipe for example");
}

[[noreturn]] void throw_none(const std::vector<Candidate>& all, std::string_view which) {
    std::string present;
    for (const Candidate& c : all) present += (present.empty() ? "" : ", ") + std::string(c.properties.deviceName);
    const std::string asked = which.empty() ? "any Vulkan device" : "`" + std::string(which) + "`";
    throw Error(
        ErrorCode::no_device, "there is no device that fits " + asked, "Device::open (GLIFT_DEVICE)",
        present.empty() ? "no Vulkan device was found" : "there is: " + present + ", host",
        present.empty()
            ? "install a driver (Debian, on the CPU: apt install mesa-vulkan-drivers), look at VK_DRIVER_FILES "
              "and VK_ICD_FILENAMES, or run on the host device: GLIFT_DEVICE=host"
            : "ask for one of those: GLIFT_DEVICE=host, or part of another's name; a GPU shows up there once its "
              "driver is installed");
}

}  // namespace

std::vector<VkQueueFamilyProperties> queue_families(const Instance& instance, VkPhysicalDevice physical) {
    std::uint32_t count = 0;
    instance.vk().vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    instance.vk().vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    return families;
}

VkPhysicalDevice select_physical_device(const Instance& instance, std::string_view which,
                                        std::span<const std::string> extensions) {
    std::vector<Candidate> all;
    for (VkPhysicalDevice physical : instance.physical_devices()) {
        const FeatureChain features(instance, physical);
        all.push_back({physical, features.properties,
                       !features.old() && features.missing().empty() &&
                           lacking_extensions(instance, physical, extensions).empty()});
    }
    const Wanted wanted = parse_wanted(which);
    std::vector<Candidate> fitting;
    for (const Candidate& candidate : all)
        if (matches(candidate, wanted.name)) fitting.push_back(candidate);
    if (wanted.index >= fitting.size()) throw_none(all, which);
    const auto order = [](const Candidate& c) { return (c.usable ? 8 : 0) + rank(c.properties.deviceType); };
    std::stable_sort(fitting.begin(), fitting.end(),
                     [&](const Candidate& a, const Candidate& b) { return order(a) > order(b); });
    const Candidate& chosen = fitting[wanted.index];
    if (!chosen.usable) {
        FeatureChain(instance, chosen.physical).require();
        require_extensions(instance, chosen, extensions);
    }
    return chosen.physical;
}

}  // namespace glift::detail
