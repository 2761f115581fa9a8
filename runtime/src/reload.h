// The environment variable GLIFT_RELOAD.
#pragma once

#include <atomic>

namespace glift {
class Reload;
}

namespace glift::detail {

/// Of the folder that GLIFT_RELOAD names when the library is loaded; null if it is not set or empty.
extern std::atomic<Reload*> named_reload;

void poll_named_reload(Reload& reload);

/// Called where the host submits or waits.
inline void poll_reload() {
    if (Reload* const reload = named_reload.load(std::memory_order_relaxed)) [[unlikely]]
        poll_named_reload(*reload);
}

}  // namespace glift::detail
