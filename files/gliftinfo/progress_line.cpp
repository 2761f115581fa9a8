#include "progress_line.h"

#include <cstdio>
#include <unistd.h>

namespace gliftinfo {

ProgressLine::ProgressLine(std::string what, std::uint64_t total)
    : what_(std::move(what)), total_(total), is_terminal_(::isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + std::chrono::seconds(1)) {}

ProgressLine::~ProgressLine() {
    if (is_shown_) std::fputs("\r\x1b[K", stderr);
}

void ProgressLine::show(std::uint64_t done) {
    done_ = done;
    if (!is_terminal_ || total_ == 0) return;
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    constexpr double mebibyte = 1 << 20;
    std::fprintf(stderr, "\r\x1b[K%s: %3.0f %% of %.0f MiB", what_.c_str(),
                 100.0 * static_cast<double>(done) / static_cast<double>(total_),
                 static_cast<double>(total_) / mebibyte);
    is_shown_ = true;
}

}  // namespace gliftinfo
