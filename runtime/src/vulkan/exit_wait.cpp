#include "exit_wait.h"

#include "timeline.h"

#include <glift/error.h>

#include <cstdlib>
#include <mutex>
#include <set>
#include <tuple>

namespace glift::detail {

namespace {

struct Live {
    std::mutex mutex;
    std::set<Timeline*> timelines;
};

/// Never destroyed, since devices in static variables are destroyed in any order.
Live& live() {
    static Live* const all = new Live;
    return *all;
}

void wait_for_all() {
    Live& all = live();
    const std::lock_guard lock(all.mutex);
    for (Timeline* timeline : all.timelines) {
        try {
            timeline->wait(timeline->submitted());
        } catch (const Error&) {
            // A lost device has no work left.
        }
    }
}

}  // namespace

ExitWait::ExitWait(Timeline& timeline) : timeline_(timeline) {
    Live& all = live();
    const std::lock_guard lock(all.mutex);
    all.timelines.insert(&timeline);
}

ExitWait::~ExitWait() {
    Live& all = live();
    const std::lock_guard lock(all.mutex);
    all.timelines.erase(&timeline_);
}

void ExitWait::renew() { std::ignore = std::atexit(wait_for_all); }

}  // namespace glift::detail
