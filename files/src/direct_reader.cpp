#include "direct_reader.h"

#include "error.h"

#include <glift/error.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <sys/mman.h>
#include <unistd.h>

namespace glift::files {

namespace {

constexpr std::size_t alignment = 4096;
constexpr std::uint64_t smallest_file = 16 << 20;

}  // namespace

DirectReader::~DirectReader() {
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    for (Slot& slot : slots_) std::free(slot.memory);
    if (mapped_) ::munmap(mapped_, end_);
}

void DirectReader::open() {
    try {
        direct_.emplace(file_.name_in_process(), O_RDONLY | O_DIRECT);
    } catch (const Error&) {
        direct_.reset();  // no direct reads here
    }
    // Only to ask what the cache has: nothing is read through it.
    void* const mapped = ::mmap(nullptr, end_, PROT_READ, MAP_SHARED, file_.number(), 0);
    if (mapped != MAP_FAILED) mapped_ = mapped;
    slots_.resize(ahead + 2);
    for (Slot& slot : slots_) {
        slot.memory = static_cast<std::byte*>(std::aligned_alloc(alignment, block_bytes));
        if (!slot.memory) throw std::bad_alloc();
    }
    for (unsigned i = 0; i < most_threads; ++i) threads_.emplace_back([this] { work(); });
}

std::size_t DirectReader::read(std::uint64_t offset, std::span<std::byte> to) {
    if (end_ < smallest_file) return file_.read(offset, to);
    if (threads_.empty()) open();
    std::size_t done = 0;
    while (done < to.size()) {
        const std::uint64_t at = offset + done, begin = at % block_bytes;
        const Slot& slot = wait_for(at / block_bytes);
        if (begin >= slot.bytes) break;
        const std::size_t bytes = std::min<std::size_t>(to.size() - done, slot.bytes - begin);
        std::memcpy(to.data() + done, slot.memory + begin, bytes);
        done += bytes;
    }
    return done;
}

DirectReader::Slot* DirectReader::slot_of(std::uint64_t block) {
    const auto found = std::ranges::find(slots_, block, &Slot::block);
    return found == slots_.end() ? nullptr : &*found;
}

/// Gives a block a slot that holds none of those that are needed, from `first_needed` on; null: there is none now.
DirectReader::Slot* DirectReader::ask_for(std::uint64_t block, std::uint64_t first_needed) {
    if (Slot* const slot = slot_of(block)) return slot;
    for (Slot& slot : slots_) {
        const bool is_needed = slot.block >= first_needed && slot.block <= first_needed + ahead;
        if (slot.state == State::reading || (slot.block != none && is_needed)) continue;
        slot.block = block;
        slot.state = State::waiting;
        slot.failure = nullptr;
        changed_.notify_all();
        return &slot;
    }
    return nullptr;
}

/// The slot with the block, once it is read. Reads further blocks ahead where this one follows the last one.
DirectReader::Slot& DirectReader::wait_for(std::uint64_t block) {
    std::unique_lock lock(mutex_);
    Slot* slot = nullptr;
    changed_.wait(lock, [&] { return (slot = ask_for(block, block)) != nullptr; });
    if (last_ == block || last_ + 1 == block)
        for (std::uint64_t next = block + 1; next <= block + ahead && next * block_bytes < end_; ++next)
            ask_for(next, block);
    last_ = block;
    changed_.wait(lock, [&] { return slot->state == State::done; });
    if (slot->failure) std::rethrow_exception(slot->failure);
    return *slot;
}

void DirectReader::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        Slot* first = nullptr;
        changed_.wait(lock, [&] {
            first = nullptr;
            for (Slot& slot : slots_)
                if (slot.state == State::waiting && (!first || slot.block < first->block)) first = &slot;
            return is_ending_ || first;
        });
        if (is_ending_) return;
        first->state = State::reading;
        lock.unlock();
        try {
            fill(*first);
        } catch (...) {
            first->failure = std::current_exception();
        }
        lock.lock();
        first->state = State::done;
        changed_.notify_all();
    }
}

/// Whether the page cache has all of these bytes, so that they cost no read of the disk.
bool DirectReader::is_cached(std::uint64_t begin, std::size_t bytes) const {
    if (!mapped_) return false;
    std::array<unsigned char, block_bytes / alignment> pages;
    const std::size_t count = (bytes + alignment - 1) / alignment;
    if (::mincore(static_cast<std::byte*>(mapped_) + begin, bytes, pages.data()) != 0) return false;
    return std::all_of(pages.begin(), pages.begin() + count, [](unsigned char page) { return (page & 1) != 0; });
}

void DirectReader::fill(Slot& slot) const {
    const std::uint64_t begin = slot.block * block_bytes;
    const std::size_t wanted = std::min(block_bytes, end_ - std::min(begin, end_));
    slot.bytes = 0;
    const bool is_direct = direct_ && !is_cached(begin, wanted);
    while (is_direct && slot.bytes < wanted && slot.bytes % alignment == 0) {
        const ssize_t n = ::pread(direct_->number(), slot.memory + slot.bytes, block_bytes - slot.bytes,
                                  static_cast<off_t>(begin + slot.bytes));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && errno == EINVAL) break;  // not aligned enough for this disk
        if (n < 0) throw_system("read", file_.path());
        if (n == 0) break;
        slot.bytes += static_cast<std::size_t>(n);
    }
    if (slot.bytes < wanted)
        slot.bytes += file_.read(begin + slot.bytes, {slot.memory + slot.bytes, wanted - slot.bytes});
}

}  // namespace glift::files
