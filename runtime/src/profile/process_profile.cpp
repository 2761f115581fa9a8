#include "process_profile.h"

#include "report.h"

#include <glift/error.h>
#include <glift/log.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <tuple>

namespace glift::detail {

namespace {

/// What is profiled, and where the report goes.
struct ProcessProfile {
    std::mutex mutex;
    std::string target;  ///< `summary`, or a file
    std::vector<std::pair<const DeviceObject*, std::weak_ptr<DeviceObject>>> live;
    std::vector<ProfileData> done;
};

/// Never destroyed, since devices in static variables are destroyed in any order.
ProcessProfile& process_profile() {
    static ProcessProfile* const profile = new ProcessProfile;
    return *profile;
}

std::string target_of(const char* text) {
    const std::string target = text;
    if (target == "summary" || target.ends_with(".json")) return target;
    throw Error(ErrorCode::wrong_argument, "the environment variable GLIFT_PROFILE has an invalid value",
                "GLIFT_PROFILE=" + target, {}, "set it to summary, or to the name of a file that ends with .json");
}

void write_file(const std::string& name, const std::string& text) {
    std::FILE* const file = std::fopen(name.c_str(), "w");
    const bool is_written = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
    const bool is_closed = file != nullptr && std::fclose(file) == 0;
    if (!is_written || !is_closed) log("GLIFT_PROFILE: cannot write " + name + ": look at the folder and its rights");
}

}  // namespace

void report_profile() {
    ProcessProfile& profile = process_profile();
    std::vector<std::shared_ptr<DeviceObject>> open;
    {
        const std::lock_guard lock(profile.mutex);
        for (const auto& [object, handle] : profile.live)
            if (auto device = handle.lock()) open.push_back(std::move(device));
    }
    for (const auto& device : open) {
        try {
            device->finish_profile();
        } catch (const Error&) {
            // The device was lost: what is known already is reported.
        }
        keep_profile(*device);
    }
    const std::lock_guard lock(profile.mutex);
    if (profile.target.empty()) return;
    if (profile.target != "summary") return write_file(profile.target, trace_of(profile.done));
    for (const ProfileData& data : profile.done) {
        const std::string text = summary_of(data);
        std::fwrite(text.data(), 1, text.size(), stderr);
    }
}

void profile_if_asked(const std::shared_ptr<DeviceObject>& device) {
    const char* const text = std::getenv("GLIFT_PROFILE");
    if (text == nullptr || *text == '\0') return;
    ProcessProfile& profile = process_profile();
    const std::string target = target_of(text);
    device->start_profile();
    const std::lock_guard lock(profile.mutex);
    if (profile.target.empty()) std::ignore = std::atexit(report_profile);
    profile.target = target;
    profile.live.emplace_back(device.get(), device);
}

void keep_profile(const DeviceObject& device) {
    ProcessProfile& profile = process_profile();
    const std::lock_guard lock(profile.mutex);
    if (std::erase_if(profile.live, [&](const auto& each) { return each.first == &device; }) == 0) return;
    ProfileData data = device.profiler().data();
    data.device = device.properties().name;
    profile.done.push_back(std::move(data));
}

}  // namespace glift::detail
