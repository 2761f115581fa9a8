#include "job_thread.h"

#include <utility>

namespace glift::detail {

JobThread::~JobThread() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
}

void JobThread::add(Job job) {
    {
        const std::lock_guard lock(mutex_);
        if (error_) return;
        jobs_.push_back(std::move(job));
        if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
    }
    added_.notify_one();
}

void JobThread::finish() {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [&] { return jobs_.empty() && !is_running_; });
    if (error_) std::rethrow_exception(error_);
}

void JobThread::check() {
    const std::lock_guard lock(mutex_);
    if (error_) std::rethrow_exception(error_);
}

void JobThread::run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (added_.wait(lock, stop, [&] { return !jobs_.empty(); })) {
        Job job = std::move(jobs_.front());
        jobs_.pop_front();
        is_running_ = true;
        lock.unlock();
        std::exception_ptr error;
        std::deque<Job> dropped;
        try {
            job();
        } catch (...) {
            error = std::current_exception();
        }
        job = nullptr;  // what it holds goes before others learn that it has ended
        lock.lock();
        if (error) {
            error_ = error;
            dropped.swap(jobs_);
        }
        is_running_ = false;
        lock.unlock();
        dropped.clear();  // which opens the gates that they hold
        ended_.notify_all();
        lock.lock();
    }
}

}  // namespace glift::detail
