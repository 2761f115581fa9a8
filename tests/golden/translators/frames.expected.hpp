// Made by gliftc from frames.glift. Changes are lost when it is made again.
#pragma once

#include "frames.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

/// Physical addresses that come from memory are compared with what they lead to; those of the table itself are not.

namespace frames {

#ifndef GLIFT_frames_HAS_Frames
#define GLIFT_frames_HAS_Frames
/// Frames, frames.glift:11.
class Frames : public glift::Structure<Frames, glift::uint, glift::uint> {
public:
    static constexpr const char* type_name = "Frames";

    Frames() = default;
    Frames(const glift::Commands& commands, glift::uint n);
    /// Over parts that exist already.
    Frames(const glift::Commands& commands, glift::uint n, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint n() const { return n_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    bool same_state(const Frames& other) const;

    /// Gives every element, or those of a box, one value.
    void fill(glift::uint value);
    void fill(glift::uint value, const glift::Range<Frames>& range);
    /// Where an element lies in row_memory(), in elements; the address is an affine function of the virtual one.
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Elements of a box to a linear buffer, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Frames>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Frames>& range, const glift::Memory& box) const;
    /// Where addresses are translated to: in the structure's own memory.
    using Place = glift::uint;
    /// Whether it translates addresses itself; else its memory does.
    static constexpr bool translates = true;
    static constexpr bool has_blocks = false;
    /// What of a box is there, `most` at most, in no particular order: see read_resident.
    void list(const glift::Commands& commands, const glift::Range<Frames>& range, glift::uint most,
        const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
        const glift::Memory& values) const;

    /// Calls a function of `see` for each part, with its name and value: see glift/inspect.h.
    template <class See> void describe(See&& see) const {
        see.value("n", n_);
        see.memory("data", data());
    }

private:
    glift::uint n_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

#ifndef GLIFT_frames_HAS_Pool
#define GLIFT_frames_HAS_Pool
/// Pool, frames.glift:27.
class Pool : public glift::Structure<Pool, glift::uint, float> {
public:
    static constexpr const char* type_name = "Pool";

    Pool() = default;
    Pool(const glift::Commands& commands, glift::uint pages, glift::uint capacity);
    /// Over parts that exist already.
    Pool(const glift::Commands& commands, glift::uint pages, glift::uint capacity, Frames frames, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint pages() const { return pages_; }
    glift::uint capacity() const { return capacity_; }
    const Frames& frames() const { return frames_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    bool same_state(const Pool& other) const;

    /// Gives every element, or those of a box, one value.
    void fill(float value);
    void fill(float value, const glift::Range<Pool>& range);
    /// Elements of a box to a linear buffer, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Pool>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Pool>& range, const glift::Memory& box) const;
    /// Where addresses are translated to: in the structure's own memory.
    using Place = glift::uint;
    /// Whether it translates addresses itself; else its memory does.
    static constexpr bool translates = true;
    static constexpr bool has_blocks = false;
    /// What of a box is there, `most` at most, in no particular order: see read_resident.
    void list(const glift::Commands& commands, const glift::Range<Pool>& range, glift::uint most,
        const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
        const glift::Memory& values) const;

    /// Calls a function of `see` for each part, with its name and value: see glift/inspect.h.
    template <class See> void describe(See&& see) const {
        see.value("pages", pages_);
        see.value("capacity", capacity_);
        see.memory("data", data());
        see.member("frames", frames());
    }

private:
    glift::uint pages_{};
    glift::uint capacity_{};
    Frames frames_;
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

void double_there(const glift::Commands& commands, const glift::Range<Pool>& s, const glift::Range<Pool>& g);

}  // namespace frames
