// Writes large runs of bytes past the page cache, on threads of its own: copying them into the cache would cost more
// time on the CPU than all else that a save does.
#pragma once

#include "descriptor.h"

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace glift::files {

class DirectWriter {
public:
    /// `file` must outlive it. Where the file system has no direct writes, bytes go through the cache.
    explicit DirectWriter(const Descriptor& file) : file_(file) {}
    DirectWriter(const DirectWriter&) = delete;
    ~DirectWriter();

    /// Begins to write a copy of the bytes. Throws wrong_argument where an earlier write failed.
    void write(std::uint64_t offset, std::span<const std::byte> bytes);
    /// Waits until all is written. Throws wrong_argument where that failed.
    void finish();

private:
    /// Bytes in a block of memory that is aligned as those of the file are.
    struct Run {
        std::uint64_t offset = 0;
        std::size_t begin = 0, bytes = 0;  ///< within the block
        std::size_t capacity = 0;
        std::byte* block = nullptr;

        void assign(std::uint64_t offset_in_file, std::span<const std::byte> from);
        void release();
    };

    void open();
    void work();
    void write_now(const Run& run) const;
    void throw_failure();

    const Descriptor& file_;
    std::optional<Descriptor> direct_;
    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Run> waiting_;
    std::vector<Run> free_;
    unsigned runs_ = 0;  ///< how many there are
    bool is_ending_ = false;
    std::exception_ptr failure_;
};

}  // namespace glift::files
