// Made by gliftc from texture_unit.glift. Changes are lost when it is made again.
#pragma once

#include "texture_unit.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

/// What images offer beside reads and writes: combined floats, shared texels, gathered texels, comparisons.

namespace texture_unit {

#ifndef GLIFT_texture_unit_HAS_Shadows
#define GLIFT_texture_unit_HAS_Shadows
/// Shadows, texture_unit.glift:7.
class Shadows : public glift::Structure<Shadows, glift::uint3, float> {
public:
    static constexpr const char* type_name = "Shadows";

    Shadows() = default;
    Shadows(const glift::Commands& commands, glift::uint2 extent, glift::uint layers);
    /// Makes the structure with the given memory.
    Shadows(const glift::Commands& commands, glift::uint2 extent, glift::uint layers, glift::Memory depths);

    glift::uint3 domain() const;
    glift::uint2 extent() const { return extent_; }
    glift::uint layers() const { return layers_; }
    const glift::Memory& depths() const { return depths_; }
    glift::uint3 depths_extent() const { return depths_extent_; }
    bool same_state(const Shadows& other) const;

    void copy_out(const glift::Commands& commands, const glift::Range<Shadows>& range, const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.value("layers", layers_);
        see.memory("depths", depths());
    }
    using Arguments = glift::Types<glift::uint2, glift::uint>;
    static constexpr std::uint64_t state_key = 11199992349460898399u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.argument("layers", layers_);
        visit.image("depths", depths_, depths_extent_);
    }

private:
    glift::uint2 extent_{};
    glift::uint layers_{};
    glift::uint3 depths_extent_{};
    glift::Memory depths_;
};
#endif

#ifndef GLIFT_texture_unit_HAS_Heights
#define GLIFT_texture_unit_HAS_Heights
/// Heights, texture_unit.glift:12.
class Heights : public glift::Structure<Heights, glift::uint2, float> {
public:
    static constexpr const char* type_name = "Heights";

    Heights() = default;
    Heights(const glift::Commands& commands, glift::uint2 extent);
    /// Makes the structure with the given memory.
    Heights(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    glift::uint2 data_extent() const { return data_extent_; }
    bool same_state(const Heights& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<Heights>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<Heights>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Heights>& range, const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint2>;
    static constexpr std::uint64_t state_key = 8860374805930689700u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.image("data", data_, data_extent_);
    }

private:
    glift::uint2 extent_{};
    glift::uint2 data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace texture_unit

namespace std_array {

#ifndef GLIFT_std_array_HAS_Array_2_uint_none_image2d
#define GLIFT_std_array_HAS_Array_2_uint_none_image2d
/// Array<2, uint, none, image2d>. A dense N-D array. Memory: one element per address; image2d rounds up to whole
/// rows. `edge` says what reads outside give, by default zero; writes outside are discarded. Lefohn's thesis
/// (Glift: Generic Data Structures for Graphics Hardware, 2006), section 9.1.
class Array_2_uint_none_image2d : public glift::Structure<Array_2_uint_none_image2d, glift::uint2, glift::uint> {
public:
    static constexpr const char* type_name = "Array<2, uint, none, image2d>";

    Array_2_uint_none_image2d() = default;
    Array_2_uint_none_image2d(const glift::Commands& commands, glift::uint2 extent);
    /// Makes the structure with the given memory.
    Array_2_uint_none_image2d(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    glift::uint2 data_extent() const { return data_extent_; }
    bool same_state(const Array_2_uint_none_image2d& other) const;

    void fill(glift::uint value);
    void fill(glift::uint value, const glift::Range<Array_2_uint_none_image2d>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<Array_2_uint_none_image2d>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Array_2_uint_none_image2d>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint2>;
    static constexpr std::uint64_t state_key = 10622061580757279181u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.image("data", data_, data_extent_);
    }

private:
    glift::uint2 extent_{};
    glift::uint2 data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_array

namespace texture_unit {

using Marks = ::std_array::Array_2_uint_none_image2d;

}  // namespace texture_unit

namespace std_array {

#ifndef GLIFT_std_array_HAS_Array_1_float3
#define GLIFT_std_array_HAS_Array_1_float3
/// Array<1, float3>. A dense N-D array. Memory: one element per address; image2d rounds up to whole rows. `edge`
/// says what reads outside give, by default zero; writes outside are discarded. Lefohn's thesis (Glift: Generic
/// Data Structures for Graphics Hardware, 2006), section 9.1.
class Array_1_float3 : public glift::Structure<Array_1_float3, glift::uint, glift::float3> {
public:
    static constexpr const char* type_name = "Array<1, float3>";

    Array_1_float3() = default;
    Array_1_float3(const glift::Commands& commands, glift::uint extent);
    /// Makes the structure with the given memory.
    Array_1_float3(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    bool same_state(const Array_1_float3& other) const;

    void fill(glift::float3 value);
    void fill(glift::float3 value, const glift::Range<Array_1_float3>& range);
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    void copy_out(const glift::Commands& commands, const glift::Range<Array_1_float3>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Array_1_float3>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint>;
    static constexpr std::uint64_t state_key = 15592328566153615568u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.buffer("data", data_, data_extent_, glift::float3{});
    }

private:
    glift::uint extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_array

namespace texture_unit {

using Points = ::std_array::Array_1_float3;

}  // namespace texture_unit

namespace std_array {

#ifndef GLIFT_std_array_HAS_Array_1_float
#define GLIFT_std_array_HAS_Array_1_float
/// Array<1, float>. A dense N-D array. Memory: one element per address; image2d rounds up to whole rows. `edge`
/// says what reads outside give, by default zero; writes outside are discarded. Lefohn's thesis (Glift: Generic
/// Data Structures for Graphics Hardware, 2006), section 9.1.
class Array_1_float : public glift::Structure<Array_1_float, glift::uint, float> {
public:
    static constexpr const char* type_name = "Array<1, float>";

    Array_1_float() = default;
    Array_1_float(const glift::Commands& commands, glift::uint extent);
    /// Makes the structure with the given memory.
    Array_1_float(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    bool same_state(const Array_1_float& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<Array_1_float>& range);
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    void copy_out(const glift::Commands& commands, const glift::Range<Array_1_float>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Array_1_float>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint>;
    static constexpr std::uint64_t state_key = 15592328566153615568u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.buffer("data", data_, data_extent_, float{});
    }

private:
    glift::uint extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_array

namespace texture_unit {

void splat(const glift::Commands& commands, const glift::Range<Points>& p, const glift::Range<Heights>& nearest,
    const glift::Range<::std_array::Array_1_float>& farthest, const glift::Range<Marks>& marks);

void light(const glift::Commands& commands, const glift::Range<Shadows>& shadows, const glift::Range<Heights>& heights,
    const glift::Range<Points>& p);

}  // namespace texture_unit
