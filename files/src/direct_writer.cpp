#include "direct_writer.h"

#include "error.h"

#include <glift/error.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <unistd.h>

namespace glift::files {

namespace {

/// Disks ask for offsets, lengths and memory that are multiples of 512 or of this.
constexpr std::size_t alignment = 4096;
/// Shorter runs are written at once, through the cache.
constexpr std::size_t shortest = 256 << 10;
constexpr unsigned most_runs = 6, most_threads = 2;

}  // namespace

void DirectWriter::Run::assign(std::uint64_t offset_in_file, std::span<const std::byte> from) {
    offset = offset_in_file;
    begin = offset % alignment;
    bytes = from.size();
    const std::size_t needed = (begin + bytes + alignment - 1) / alignment * alignment;
    if (needed > capacity) {
        release();
        block = static_cast<std::byte*>(std::aligned_alloc(alignment, needed));
        if (!block) throw std::bad_alloc();
        capacity = needed;
    }
    std::memcpy(block + begin, from.data(), bytes);
}

void DirectWriter::Run::release() {
    std::free(block);
    block = nullptr;
    capacity = 0;
}

DirectWriter::~DirectWriter() {
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    for (Run& run : free_) run.release();
    for (Run& run : waiting_) run.release();
}

void DirectWriter::open() {
    try {
        direct_.emplace(file_.name_in_process(), O_WRONLY | O_DIRECT);
    } catch (const Error&) {
        direct_.reset();  // no direct writes here
    }
    for (unsigned i = 0; i < most_threads; ++i) threads_.emplace_back([this] { work(); });
}

void DirectWriter::write(std::uint64_t offset, std::span<const std::byte> bytes) {
    if (bytes.size() < shortest) return file_.write(offset, bytes);
    if (threads_.empty()) open();
    Run run;
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return failure_ || !free_.empty() || runs_ < most_runs; });
        throw_failure();
        if (free_.empty()) ++runs_;
        else run = free_.back(), free_.pop_back();
    }
    try {
        run.assign(offset, bytes);
    } catch (const std::bad_alloc&) {
        const std::lock_guard lock(mutex_);
        --runs_;
        throw;
    }
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(run);
    }
    changed_.notify_all();
}

void DirectWriter::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return failure_ || free_.size() == runs_; });
    throw_failure();
}

void DirectWriter::throw_failure() {
    if (failure_) std::rethrow_exception(failure_);
}

void DirectWriter::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return is_ending_ || !waiting_.empty(); });
        if (is_ending_) return;
        const Run run = waiting_.front();
        waiting_.pop_front();
        lock.unlock();
        std::exception_ptr failure;
        try {
            write_now(run);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        free_.push_back(run);
        if (failure && !failure_) failure_ = failure;
        changed_.notify_all();
    }
}

/// The first and the last bytes, which do not fill a block of the disk, go through the cache.
void DirectWriter::write_now(const Run& run) const {
    const std::size_t end = run.begin + run.bytes;
    const std::size_t first = (run.begin + alignment - 1) / alignment * alignment, last = end / alignment * alignment;
    const auto place = [&](std::size_t at) { return run.offset - run.begin + at; };
    const auto through_cache = [&](std::size_t from, std::size_t to) {
        if (from < to) file_.write(place(from), {run.block + from, to - from});
    };
    through_cache(run.begin, first);
    std::size_t at = first;
    while (direct_ && at < last) {
        const ssize_t n = ::pwrite(direct_->number(), run.block + at, last - at, static_cast<off_t>(place(at)));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && errno == EINVAL) break;  // not aligned enough for this disk
        if (n < 0) throw_system("write", file_.path());
        at += static_cast<std::size_t>(n);
        if (at % alignment != 0) break;
    }
    through_cache(at, last);
    through_cache(last, end);
}

}  // namespace glift::files
