// Made by gliftc from shared.glift. Changes are lost when it is made again.
#pragma once

#include "shared.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

/// Memory that is a structure: made for the one that has it (as in `Paged`), or a given one (as in `Same`). A frame
/// that the table gives may be beyond the memory: its elements are absent. Of a physical address, {element in its
/// page, frame}, only the frame is checked: the compiler proves that the other lies inside.

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

namespace shared {

using Table = ::std_array::Array_1_uint;

}  // namespace shared

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

namespace shared {

using Plane = ::std_array::Array_2_float;

#ifndef GLIFT_shared_HAS_Paged
#define GLIFT_shared_HAS_Paged
/// Paged, shared.glift:27.
class Paged : public glift::Structure<Paged, glift::uint, float> {
public:
    static constexpr const char* type_name = "Paged";

    Paged() = default;
    Paged(const glift::Commands& commands, const Table& table, glift::uint extent, glift::uint capacity);
    /// Makes the structure with the given nested structures.
    Paged(const glift::Commands& commands, const Table& table, glift::uint extent, glift::uint capacity, Plane frames);

    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    glift::uint capacity() const { return capacity_; }
    const Table& table() const { return table_; }
    Table& table() { return table_; }
    const Plane& frames() const { return frames_; }
    Plane& frames() { return frames_; }
    bool same_state(const Paged& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<Paged>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<Paged>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Paged>& range, const glift::Memory& box) const;
    /// The type of the physical addresses to which addresses are translated.
    using Place = glift::uint2;
    /// Whether the structure has translators itself; else its memory, a structure, translates.
    static constexpr bool translates = true;
    static constexpr bool has_blocks = false;
    /// Counts the resident elements of a box, and lists at most `most` of them in any order: see read_resident.
    void list(const glift::Commands& commands, const glift::Range<Paged>& range, glift::uint most,
        const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
        const glift::Memory& values) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.value("capacity", capacity_);
        see.given("table", table());
        see.memory("frames", frames());
    }
    static constexpr std::uint64_t state_key = 2625966122426724299u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.argument("capacity", capacity_);
        visit.given("table", table_);
        visit.base("frames", frames_);
    }

private:
    glift::uint extent_{};
    glift::uint capacity_{};
    Table table_;
    Plane frames_;
};
#endif

#ifndef GLIFT_shared_HAS_Same
#define GLIFT_shared_HAS_Same
/// The same elements under the same addresses.
class Same : public glift::Structure<Same, glift::uint, float> {
public:
    static constexpr const char* type_name = "Same";

    Same() = default;
    Same(const glift::Commands& commands, const Paged& field);

    glift::uint domain() const;
    const Paged& field() const { return field_; }
    Paged& field() { return field_; }
    const Paged& elements() const { return field_; }
    Paged& elements() { return field_; }
    bool same_state(const Same& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<Same>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<Same>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Same>& range, const glift::Memory& box) const;
    /// The type of the physical addresses to which addresses are translated.
    using Place = glift::uint2;
    /// Whether the structure has translators itself; else its memory, a structure, translates.
    static constexpr bool translates = false;
    static constexpr bool has_blocks = false;
    /// Counts the resident elements of a box, and lists at most `most` of them in any order: see read_resident.
    void list(const glift::Commands& commands, const glift::Range<Same>& range, glift::uint most,
        const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
        const glift::Memory& values) const;

    template <class See> void describe(See&& see) const {
        see.memory("field", field());
    }
    static constexpr std::uint64_t state_key = 11758983413272085780u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.given("field", field_);
    }

private:
    Paged field_;
};
#endif

#ifndef GLIFT_shared_HAS_Growing
#define GLIFT_shared_HAS_Growing
/// Has room for more after `grow`.
class Growing {
public:
    static constexpr const char* type_name = "Growing";

    Growing() = default;
    Growing(const glift::Commands& commands, glift::uint n);

    const glift::Device& device() const {
        if (!device_) glift::detail::throw_empty_structure(type_name, "device");
        return device_;
    }
    glift::uint n() const { return n_; }
    const Plane& frames() const { return frames_.get(); }
    Plane& frames() { return frames_.get(); }
    glift::uint capacity() const { return capacity_.get(); }
    bool same_state(const Growing& other) const;

    template <class See> void describe(See&& see) const {
        see.value("n", n_);
        see.value("capacity", capacity());
        see.member("frames", frames());
    }
    using Arguments = glift::Types<glift::uint>;
    static constexpr std::uint64_t state_key = 9443987671522752921u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("n", n_);
        visit.host("capacity", capacity_.get());
        visit.member("frames", frames_.get());
    }

    void grow(const glift::Commands& commands);

private:
    glift::Device device_;
    glift::uint n_{};
    glift::Shared<Plane> frames_;
    glift::Shared<glift::uint> capacity_;
};
#endif

void add(const glift::Commands& commands, const glift::Range<Paged>& f, const glift::Range<Same>& g,
    const glift::Range<Paged>& to);

void move(const glift::Commands& commands, const glift::Range<Paged>& from, const glift::Range<Paged>& a,
    const glift::Range<Paged>& to);

}  // namespace shared
