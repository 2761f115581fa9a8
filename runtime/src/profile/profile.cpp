// The functions of Profile.
#include <glift/profile.h>

#include "../check.h"
#include "../objects.h"
#include "../recording_scope.h"
#include "report.h"

namespace glift {

struct Profile::State {
    std::shared_ptr<detail::DeviceObject> device;
    detail::ProfileData before;

    detail::ProfileData data(const char* call) const {
        detail::require_no_recording(*device, call);
        device->stream().wait();
        device->finish_profile();
        detail::ProfileData data = detail::since(before, device->profiler().data());
        data.device = device->properties().name;
        return data;
    }
};

Profile::Profile(const Device& device)
    : state_(std::make_unique<State>(State{detail::shared_device(device, "Profile"), {}})) {
    detail::require_no_recording(*state_->device, "Profile");
    state_->device->start_profile();
    state_->device->stream().wait();  // commands given before this are not of the profile
    state_->device->finish_profile();
    state_->before = state_->device->profiler().data();
}

Profile::~Profile() { state_->device->profiler().turn_off(); }

std::vector<PassProfile> Profile::passes() const { return detail::passes_of(state_->data("Profile::passes")); }
std::string Profile::summary() const { return detail::summary_of(state_->data("Profile::summary")); }

std::string Profile::trace() const {
    const detail::ProfileData data = state_->data("Profile::trace");
    return detail::trace_of(std::span(&data, 1));
}

}  // namespace glift
