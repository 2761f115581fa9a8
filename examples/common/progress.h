// A line on the terminal that says how far a long work is.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>

namespace progress {

/// The text of the line: "step 60 of 240 [=====>              ] 3 s left: 812 pages", where `what` is "step" and `more`
/// is "812 pages". `seconds` have passed since the work began. The text is cut to `width` characters.
std::string text_of(const std::string& what, std::uint64_t done, std::uint64_t all, double seconds,
                    const std::string& more, std::size_t width);

/// Keeps one line of a terminal up to date, in place. Writes nothing where the stream is no terminal, so that output in
/// files and tests has results only. The destructor erases the line.
class Line {
public:
    /// `what` names the things that are counted: "step", "picture".
    explicit Line(std::string what, std::FILE* to = stdout);
    ~Line() { clear(); }
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;

    /// Shows that `done` of `all` are done; ten times a second at most, but for the first and the last one.
    void show(std::uint64_t done, std::uint64_t all, const std::string& more = {});
    /// Erases the line, for other text to come.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    std::FILE* to_;
    bool is_terminal_, is_shown_ = false;
    Clock::time_point start_ = Clock::now(), last_ = start_ - std::chrono::seconds(1);
};

}  // namespace progress
