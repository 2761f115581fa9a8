// Runs independent work items on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <future>
#include <optional>
#include <thread>
#include <vector>

namespace gliftc {

/// A counter shared by threads: take() returns each number below `count` once, whichever thread calls it, and nothing
/// afterwards.
class Tickets {
public:
    explicit Tickets(std::size_t count) : count_(count) {}
    std::optional<std::size_t> take() {
        const std::size_t number = next_++;
        return number < count_ ? std::optional(number) : std::nullopt;
    }

private:
    std::atomic<std::size_t> next_ = 0;
    std::size_t count_;
};

/// The number of threads for `count` work items: at most one per processor, and so few that each has at least `share`
/// items, since a thread for fewer items costs more than it saves; one thread if there are fewer than `share` items.
inline std::size_t threads_for(std::size_t count, std::size_t share) {
    return std::clamp<std::size_t>(count / share, 1, std::max(1u, std::thread::hardware_concurrency()));
}

/// Calls work() once on each of `threads` threads, the calling one included, and waits for all. If calls throw, throws
/// one of their exceptions.
template <class Work> void on_threads(std::size_t threads, Work&& work) {
    std::vector<std::future<void>> others;
    for (std::size_t i = 1; i < threads; ++i) others.push_back(std::async(std::launch::async, std::ref(work)));
    work();
    for (std::future<void>& other : others) other.get();
}

/// Calls work(i) for every i below `count`, in no particular order, on threads_for(count, share) threads.
template <class Work> void for_each_parallel(std::size_t count, std::size_t share, Work&& work) {
    Tickets tickets(count);
    on_threads(threads_for(count, share), [&] {
        while (auto i = tickets.take()) work(*i);
    });
}

}  // namespace gliftc
