// Messages that no call can return: a default that the runtime chose, an error in a destructor.
#pragma once

#include <glift/api.h>

#include <functional>
#include <string_view>

namespace glift {

/// Receives one message, without a newline at its end. Called from any thread, perhaps from several at once.
using Log = std::function<void(std::string_view message)>;

/// Messages go to `log` from now on; an empty function silences them. Returns the previous function. At first messages
/// are written to stderr, unless the environment variable GLIFT_QUIET is 1.
GLIFT_API Log set_log(Log log);

namespace detail {

GLIFT_API void log(std::string_view message);

}  // namespace detail

}  // namespace glift
