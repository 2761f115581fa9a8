// Made by gliftc from near.glift. Changes are lost when it is made again.
#pragma once

#include "near.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

/// A window around the current element.

namespace std_array {

#ifndef GLIFT_std_array_HAS_Array_3_float
#define GLIFT_std_array_HAS_Array_3_float
/// Array<3, float>. A dense N-D array. Memory: one element per address; image2d rounds up to whole rows. `edge`
/// says what reads outside give, by default zero; writes outside are discarded. Lefohn's thesis (Glift: Generic
/// Data Structures for Graphics Hardware, 2006), section 9.1.
class Array_3_float : public glift::Structure<Array_3_float, glift::uint3, float> {
public:
    static constexpr const char* type_name = "Array<3, float>";

    Array_3_float() = default;
    Array_3_float(const glift::Commands& commands, glift::uint3 extent);
    /// Makes the structure with the given memory.
    Array_3_float(const glift::Commands& commands, glift::uint3 extent, glift::Memory data);

    glift::uint3 domain() const;
    glift::uint3 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    bool same_state(const Array_3_float& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<Array_3_float>& range);
    std::uint64_t place(glift::uint3 address) const;
    const glift::Memory& row_memory() const { return data_; }
    void copy_out(const glift::Commands& commands, const glift::Range<Array_3_float>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Array_3_float>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint3>;
    static constexpr std::uint64_t state_key = 10534299229263452396u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.buffer("data", data_, data_extent_, float{});
    }

private:
    glift::uint3 extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_array

namespace near_ {

using Field = ::std_array::Array_3_float;

void smooth(const glift::Commands& commands, const glift::Range<Field>& f, const glift::Range<Field>& g);

}  // namespace near_
