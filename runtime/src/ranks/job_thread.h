// A thread that runs jobs in turn.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace glift::detail {

/// Runs jobs in the order in which they are added. After a job has thrown, no other one runs.
class JobThread {
public:
    using Job = std::function<void()>;

    ~JobThread();

    void add(Job job);
    /// Returns when all jobs have ended; throws what one of them threw.
    void finish();
    /// Throws what a job has thrown.
    void check();

private:
    void run(const std::stop_token& stop);

    std::mutex mutex_;
    std::condition_variable_any added_, ended_;
    std::deque<Job> jobs_;
    bool is_running_ = false;
    std::exception_ptr error_;
    std::jthread thread_;  ///< started by the first job
};

}  // namespace glift::detail
