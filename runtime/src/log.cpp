#include <glift/log.h>

#include "environment.h"

#include <cstdio>
#include <mutex>
#include <string>
#include <utility>

namespace glift {

namespace {

void write_to_stderr(std::string_view message) {
    const std::string line =
        "glift: " + std::string(message) + "\n";  // one write, so that lines of threads do not interleave
    std::fwrite(line.data(), 1, line.size(), stderr);
}

std::mutex& log_mutex() {
    static std::mutex mutex;
    return mutex;
}

Log& current_log() {
    static Log log = detail::environment_flag("GLIFT_QUIET") ? Log() : Log(write_to_stderr);
    return log;
}

}  // namespace

Log set_log(Log log) {
    const std::lock_guard lock(log_mutex());
    return std::exchange(current_log(), std::move(log));
}

void detail::log(std::string_view message) {
    Log log;
    {
        const std::lock_guard lock(log_mutex());
        log = current_log();
    }
    if (log) log(message);
}

}  // namespace glift
