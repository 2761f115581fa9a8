// Ends a test program whose test takes too long.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace glift::detail {

/// A thread that waits while a test runs. If the test takes longer than `most` (0: no limit), it prints the test as
/// failed, with the device that it was running on, and ends the process with code 1: a test that hangs cannot be
/// stopped in any other way.
class TestWatchdog {
public:
    explicit TestWatchdog(std::chrono::seconds most);
    ~TestWatchdog();
    TestWatchdog(const TestWatchdog&) = delete;

    /// What is running now.
    void name(std::string test, std::string device);

    /// The time of one test.
    class Watch {
    public:
        explicit Watch(TestWatchdog& watchdog) : watchdog_(watchdog) { watchdog_.begin(); }
        ~Watch() { watchdog_.end(); }
        Watch(const Watch&) = delete;

    private:
        TestWatchdog& watchdog_;
    };

private:
    void begin();
    void end();
    void watch();

    const std::chrono::seconds most_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::string test_, device_;
    std::chrono::steady_clock::time_point deadline_ = std::chrono::steady_clock::time_point::max();
    bool is_done_ = false;
    std::thread thread_;
};

}  // namespace glift::detail
