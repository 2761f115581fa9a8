// How far a command is: one line on standard error, which overwrites itself.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace gliftinfo {

/// Shows nothing unless standard error is a terminal, and nothing in the first second.
class ProgressLine {
public:
    /// `total`: bytes, of which show() or add() says how many are done.
    ProgressLine(std::string what, std::uint64_t total);
    ProgressLine(const ProgressLine&) = delete;
    ~ProgressLine();  ///< removes the line
    void show(std::uint64_t done);
    void add(std::uint64_t bytes) { show(done_ + bytes); }

private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    std::uint64_t total_, done_ = 0;
    bool is_terminal_, is_shown_ = false;
    Clock::time_point next_;
};

}  // namespace gliftinfo
