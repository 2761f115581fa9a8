// Made by gliftc from near_blocks.glift. Changes are lost when it is made again.
#pragma once

#include "near_blocks.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

/// Windows over blocks: what they read is copied once a block on the host device.

namespace std_array {

#ifndef GLIFT_std_array_HAS_Array_1_uint
#define GLIFT_std_array_HAS_Array_1_uint
/// Array<1, uint>. A dense N-D array. Memory: one element per address; image2d rounds up to whole rows. `edge` says
/// what reads outside give, by default zero; writes outside are discarded. Lefohn's thesis (Glift: Generic Data
/// Structures for Graphics Hardware, 2006), section 9.1.
class Array_1_uint : public glift::Structure<Array_1_uint, glift::uint, glift::uint> {
public:
    static constexpr const char* type_name = "Array<1, uint>";

    Array_1_uint() = default;
    Array_1_uint(const glift::Commands& commands, glift::uint extent);
    /// Makes the structure with the given memory.
    Array_1_uint(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    bool same_state(const Array_1_uint& other) const;

    void fill(glift::uint value);
    void fill(glift::uint value, const glift::Range<Array_1_uint>& range);
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    void copy_out(const glift::Commands& commands, const glift::Range<Array_1_uint>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Array_1_uint>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint>;
    static constexpr std::uint64_t state_key = 15592328566153615568u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.buffer("data", data_, data_extent_, glift::uint{});
    }

private:
    glift::uint extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_array

namespace near_blocks {

using Numbers = ::std_array::Array_1_uint;

}  // namespace near_blocks

namespace std_array {

#ifndef GLIFT_std_array_HAS_Array_2_float
#define GLIFT_std_array_HAS_Array_2_float
/// Array<2, float>. A dense N-D array. Memory: one element per address; image2d rounds up to whole rows. `edge`
/// says what reads outside give, by default zero; writes outside are discarded. Lefohn's thesis (Glift: Generic
/// Data Structures for Graphics Hardware, 2006), section 9.1.
class Array_2_float : public glift::Structure<Array_2_float, glift::uint2, float> {
public:
    static constexpr const char* type_name = "Array<2, float>";

    Array_2_float() = default;
    Array_2_float(const glift::Commands& commands, glift::uint2 extent);
    /// Makes the structure with the given memory.
    Array_2_float(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    bool same_state(const Array_2_float& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<Array_2_float>& range);
    std::uint64_t place(glift::uint2 address) const;
    const glift::Memory& row_memory() const { return data_; }
    void copy_out(const glift::Commands& commands, const glift::Range<Array_2_float>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Array_2_float>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint2>;
    static constexpr std::uint64_t state_key = 10746358178786628004u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.buffer("data", data_, data_extent_, float{});
    }

private:
    glift::uint2 extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_array

namespace near_blocks {

#ifndef GLIFT_near_blocks_HAS_Listed
#define GLIFT_near_blocks_HAS_Listed
/// Paged memory. Its blocks are the pages in the list `active`.
class Listed : public glift::Structure<Listed, glift::uint2, float> {
public:
    static constexpr const char* type_name = "Listed";

    Listed() = default;
    Listed(const glift::Commands& commands, const Numbers& table, const Numbers& active, glift::uint2 extent,
        glift::uint capacity);
    /// Makes the structure with the given nested structures.
    Listed(const glift::Commands& commands, const Numbers& table, const Numbers& active, glift::uint2 extent,
        glift::uint capacity, ::std_array::Array_2_float frames);

    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    glift::uint capacity() const { return capacity_; }
    const Numbers& table() const { return table_; }
    Numbers& table() { return table_; }
    const Numbers& active() const { return active_; }
    Numbers& active() { return active_; }
    const ::std_array::Array_2_float& frames() const { return frames_; }
    ::std_array::Array_2_float& frames() { return frames_; }
    bool same_state(const Listed& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<Listed>& range);
    /// The extent of every block.
    glift::uint2 block_extent() const;
    void copy_out(const glift::Commands& commands, const glift::Range<Listed>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Listed>& range, const glift::Memory& box) const;
    /// The type of the physical addresses to which addresses are translated.
    using Place = glift::uint2;
    /// Whether the structure has translators itself; else its memory, a structure, translates.
    static constexpr bool translates = true;
    static constexpr bool has_blocks = true;
    /// Counts the resident elements of a box, and lists at most `most` of them in any order: see read_resident.
    void list(const glift::Commands& commands, const glift::Range<Listed>& range, glift::uint most,
        const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
        const glift::Memory& values) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.value("capacity", capacity_);
        see.given("table", table());
        see.given("active", active());
        see.memory("frames", frames());
    }
    static constexpr std::uint64_t state_key = 14314424904214654248u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.argument("capacity", capacity_);
        visit.given("table", table_);
        visit.given("active", active_);
        visit.base("frames", frames_);
    }

private:
    glift::uint2 extent_{};
    glift::uint capacity_{};
    Numbers table_;
    Numbers active_;
    ::std_array::Array_2_float frames_;
};
#endif

void right(const glift::Commands& commands, const glift::Range<Listed>& f, const glift::Range<Listed>& g);

}  // namespace near_blocks
