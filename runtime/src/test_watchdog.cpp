#include "test_watchdog.h"

#include <cstdio>
#include <cstdlib>

namespace glift::detail {

namespace {

constexpr auto never = std::chrono::steady_clock::time_point::max();

}  // namespace

TestWatchdog::TestWatchdog(std::chrono::seconds most) : most_(most) {
    if (most_.count() > 0) thread_ = std::thread([this] { watch(); });
}

TestWatchdog::~TestWatchdog() {
    {
        const std::lock_guard lock(mutex_);
        is_done_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void TestWatchdog::name(std::string test, std::string device) {
    const std::lock_guard lock(mutex_);
    test_ = std::move(test);
    device_ = std::move(device);
}

void TestWatchdog::begin() {
    {
        const std::lock_guard lock(mutex_);
        deadline_ = std::chrono::steady_clock::now() + most_;
    }
    changed_.notify_all();
}

void TestWatchdog::end() {
    const std::lock_guard lock(mutex_);
    deadline_ = never;
}

void TestWatchdog::watch() {
    std::unique_lock lock(mutex_);
    while (!is_done_) {
        if (deadline_ == never) {
            changed_.wait(lock);
        } else if (std::chrono::steady_clock::now() < deadline_) {
            changed_.wait_until(lock, deadline_);
        } else {
            std::printf("FAIL  %s\n      no result after %lld s (--timeout) [%s]; what follows it did not run\n",
                        test_.c_str(), static_cast<long long>(most_.count()), device_.c_str());
            std::fflush(stdout);
            std::_Exit(1);
        }
    }
}

}  // namespace glift::detail
