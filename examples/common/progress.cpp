#include "progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace progress {

namespace {

std::size_t width_of(std::FILE* terminal) {
    winsize size{};
    if (ioctl(fileno(terminal), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

std::string duration(double seconds) {
    const auto whole = static_cast<std::uint64_t>(std::ceil(seconds));
    if (whole < 120) return std::to_string(whole) + " s";
    if (whole < 7200) return std::to_string(whole / 60) + " min";
    return std::to_string(whole / 3600) + " h";
}

}  // namespace

std::string text_of(const std::string& what, std::uint64_t done, std::uint64_t all, double seconds,
                    const std::string& more, std::size_t width) {
    constexpr std::size_t cells = 20;
    done = std::min(done, all);
    const double share = all == 0 ? 1 : static_cast<double>(done) / static_cast<double>(all);
    const auto full = static_cast<std::size_t>(share * cells);
    std::string text = what + " " + std::to_string(done) + " of " + std::to_string(all) + " [" + std::string(full, '=');
    if (full < cells) text += ">" + std::string(cells - full - 1, ' ');
    text += "]";
    if (done > 0 && done < all) text += " " + duration(seconds * (1 - share) / share) + " left";
    if (!more.empty()) text += ": " + more;
    return text.substr(0, width);
}

Line::Line(std::string what, std::FILE* to) : what_(std::move(what)), to_(to), is_terminal_(isatty(fileno(to)) == 1) {}

void Line::show(std::uint64_t done, std::uint64_t all, const std::string& more) {
    if (!is_terminal_) return;
    const Clock::time_point now = Clock::now();
    if (is_shown_ && done < all && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    is_shown_ = true;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    // One character less than the terminal is wide: after one in the last column some terminals begin a new line.
    const std::string text = text_of(what_, done, all, seconds, more, width_of(to_) - 1);
    std::fprintf(to_, "\r\x1b[K%s", text.c_str());
    std::fflush(to_);
}

void Line::clear() {
    if (!is_shown_) return;
    is_shown_ = false;
    std::fprintf(to_, "\r\x1b[K");
    std::fflush(to_);
}

}  // namespace progress
