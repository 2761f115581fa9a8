// Made by gliftc from frames.glift. Changes are lost when it is made again.
#pragma once

#include "frames.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

/// Physical addresses from a table are checked against the extent of the memory; in the table the domain is enough.

namespace frames {

#ifndef GLIFT_frames_HAS_Frames
#define GLIFT_frames_HAS_Frames
/// Frames, frames.glift:11.
class Frames : public glift::Structure<Frames, glift::uint, glift::uint> {
public:
    static constexpr const char* type_name = "Frames";

    Frames() = default;
    Frames(const glift::Commands& commands, glift::uint n);
    /// Makes the structure with the given memory.
    Frames(const glift::Commands& commands, glift::uint n, glift::Memory data);

    glift::uint domain() const;
    glift::uint n() const { return n_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    bool same_state(const Frames& other) const;

    void fill(glift::uint value);
    void fill(glift::uint value, const glift::Range<Frames>& range);
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    void copy_out(const glift::Commands& commands, const glift::Range<Frames>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Frames>& range, const glift::Memory& box) const;
    /// The type of the physical addresses to which addresses are translated.
    using Place = glift::uint;
    /// Whether the structure has translators itself; else its memory, a structure, translates.
    static constexpr bool translates = true;
    static constexpr bool has_blocks = false;
    /// Counts the resident elements of a box, and lists at most `most` of them in any order: see read_resident.
    void list(const glift::Commands& commands, const glift::Range<Frames>& range, glift::uint most,
        const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
        const glift::Memory& values) const;

    template <class See> void describe(See&& see) const {
        see.value("n", n_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint>;
    static constexpr std::uint64_t state_key = 15894058583617198654u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("n", n_);
        visit.buffer("data", data_, data_extent_, glift::uint{});
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
    Pool(const glift::Commands& commands, glift::uint pages, glift::uint capacity = 8u);
    /// Makes the structure with the given nested structures and memory.
    Pool(const glift::Commands& commands, glift::uint pages, glift::uint capacity, Frames frames, glift::Memory data);

    glift::uint domain() const;
    glift::uint pages() const { return pages_; }
    glift::uint capacity() const { return capacity_; }
    const Frames& frames() const { return frames_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    bool same_state(const Pool& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<Pool>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<Pool>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Pool>& range, const glift::Memory& box) const;
    /// The type of the physical addresses to which addresses are translated.
    using Place = glift::uint;
    /// Whether the structure has translators itself; else its memory, a structure, translates.
    static constexpr bool translates = true;
    static constexpr bool has_blocks = false;
    /// Counts the resident elements of a box, and lists at most `most` of them in any order: see read_resident.
    void list(const glift::Commands& commands, const glift::Range<Pool>& range, glift::uint most,
        const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
        const glift::Memory& values) const;

    template <class See> void describe(See&& see) const {
        see.value("pages", pages_);
        see.value("capacity", capacity_);
        see.memory("data", data());
        see.member("frames", frames());
    }
    using Arguments = glift::Types<glift::uint, glift::uint>;
    static constexpr std::uint64_t state_key = 7254612061875354506u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("pages", pages_);
        visit.argument("capacity", capacity_);
        visit.buffer("data", data_, data_extent_, float{});
        visit.member("frames", frames_);
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
