// Which memories were accessed since the last barrier, and whether another access needs a barrier.
//
// Each barrier orders all passes and copies before it against all after it. So the question is only whether a memory of
// the next pass was written since the last barrier, or was read and is now written. A write after a write needs a
// barrier too (the validation layer does not report it between dispatches).
#pragma once

#include <glift/pass.h>

#include <cstdint>
#include <vector>

namespace glift::detail {

/// Identifies a memory: a small index, reused after the memory is gone, and a serial number that is never reused.
struct MemoryId {
    std::uint32_t slot = 0;
    std::uint64_t serial = 0;
};

class Hazards {
public:
    bool conflicts(MemoryId id, Access access) const {
        if (storage_was_reused_) return true;
        if (id.slot >= states_.size()) return false;
        const State& state = states_[id.slot];
        if (state.epoch != epoch_ || state.serial != id.serial) return false;
        return state.written || access != Access::read;
    }

    void note(MemoryId id, Access access) {
        if (id.slot >= states_.size()) states_.resize(id.slot + 16);
        State& state = states_[id.slot];
        if (state.serial != id.serial) state = {.serial = id.serial};
        if (state.epoch != epoch_) state.written = false;
        state.epoch = epoch_;
        if (access == Access::read) return;
        state.written = true;
        state.written_at = ++writes_;
    }

    /// `writes` is the number of writes so far. `was_written_since`: whether a memory has been written since that
    /// number was `writes`.
    std::uint64_t writes() const { return writes_; }
    bool was_written_since(MemoryId id, std::uint64_t writes) const {
        if (id.slot >= states_.size()) return false;
        const State& state = states_[id.slot];
        return state.serial == id.serial && state.written_at > writes;
    }

    /// Notes that a new memory has storage that others used: the next access of any memory needs a barrier before it.
    void note_storage_reuse() { storage_was_reused_ = true; }

    /// The number of writes that a barrier has followed.
    std::uint64_t ordered_writes() const { return ordered_; }

    /// After a barrier nothing is pending.
    void barrier() {
        ordered_ = writes_;
        ++epoch_;
        storage_was_reused_ = false;
    }

private:
    struct State {
        std::uint64_t serial = 0;
        std::uint64_t epoch = 0;
        bool written = false;
        std::uint64_t written_at = 0;
    };
    std::vector<State> states_;
    std::uint64_t epoch_ = 1;
    std::uint64_t writes_ = 0;
    std::uint64_t ordered_ = 0;
    bool storage_was_reused_ = false;
};

}  // namespace glift::detail
