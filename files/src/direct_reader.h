// Reads a file ahead of where it is read, past the page cache, on threads of its own: copying the bytes into the cache
// would cost more time on the CPU than all else that a load does.
#pragma once

#include "descriptor.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

namespace glift::files {

class DirectReader {
public:
    /// `file` must outlive it. Where the file system has no direct reads, and for small files, bytes come through the
    /// cache; and always where the cache has them already.
    explicit DirectReader(const Descriptor& file) : file_(file), end_(file.size()) {}
    DirectReader(const DirectReader&) = delete;
    ~DirectReader();

    /// As Descriptor::read; for one thread at a time.
    std::size_t read(std::uint64_t offset, std::span<std::byte> to);

private:
    static constexpr std::uint64_t block_bytes = 4 << 20, none = UINT64_MAX;
    static constexpr unsigned ahead = 8, most_threads = 4;

    enum class State : std::uint8_t { idle, waiting, reading, done };
    struct Slot {
        std::uint64_t block = none;
        State state = State::idle;
        std::size_t bytes = 0;
        std::byte* memory = nullptr;
        std::exception_ptr failure;
    };

    void open();
    void work();
    void fill(Slot& slot) const;
    bool is_cached(std::uint64_t begin, std::size_t bytes) const;
    Slot* slot_of(std::uint64_t block);
    Slot* ask_for(std::uint64_t block, std::uint64_t first_needed);
    Slot& wait_for(std::uint64_t block);

    const Descriptor& file_;
    std::uint64_t end_;
    std::optional<Descriptor> direct_;
    void* mapped_ = nullptr;
    std::vector<Slot> slots_;
    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint64_t last_ = none;  ///< the block that was read last
    bool is_ending_ = false;
};

}  // namespace glift::files
