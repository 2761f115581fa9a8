// Made by gliftc from predicates.glift. Changes are lost when it is made again.
#pragma once

#include "predicates.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

/// Kernels with a group load a value under a branch where nothing but a choice (a bounds check, `?:`) uses it.

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

namespace predicates {

using Line = ::std_array::Array_1_uint;

/// Each load is under the branch of its bounds check. The choices of an address and of `chosen` stay selects: no
/// load is needed for one of their sides alone.
void shift(const glift::Commands& commands, const glift::Range<Line>& x, const glift::Range<Line>& from, glift::uint by,
    const glift::Range<Line>& to);

/// Two choices between `x` and another value: each loads `x` under a branch.
void pick(const glift::Commands& commands, const glift::Range<Line>& x, const glift::Range<Line>& to);

}  // namespace predicates
