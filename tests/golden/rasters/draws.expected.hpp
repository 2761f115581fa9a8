// Made by gliftc from draws.glift. Changes are lost when it is made again.
#pragma once

#include "draws.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

/// A draw of each kind: a mesh with depth, blended instances, and fragments that count.

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

namespace draws {

using Points = ::std_array::Array_1_float3;

}  // namespace draws

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

namespace draws {

using Corners = ::std_array::Array_1_uint;

}  // namespace draws

namespace std_image {

#ifndef GLIFT_std_image_HAS_Image_rgba8
#define GLIFT_std_image_HAS_Image_rgba8
/// Image<rgba8>. A 2-D image of texel format or type F. `sample` filters it linearly, if texels are floats; its
/// coordinates are in texels, the centre of texel (0, 0) at (0.5, 0.5); beyond the edge the nearest texel counts.
/// Reads outside give zero, writes there go nowhere.
class Image_rgba8 : public glift::Structure<Image_rgba8, glift::uint2, glift::float4> {
public:
    static constexpr const char* type_name = "Image<rgba8>";

    Image_rgba8() = default;
    Image_rgba8(const glift::Commands& commands, glift::uint2 extent);
    /// Makes the structure with the given memory.
    Image_rgba8(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    glift::uint2 data_extent() const { return data_extent_; }
    bool same_state(const Image_rgba8& other) const;

    void fill(glift::float4 value);
    void fill(glift::float4 value, const glift::Range<Image_rgba8>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<Image_rgba8>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Image_rgba8>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint2>;
    static constexpr std::uint64_t state_key = 14087485589150968480u;
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

}  // namespace std_image

namespace draws {

using Colour = ::std_image::Image_rgba8;

}  // namespace draws

namespace std_image {

#ifndef GLIFT_std_image_HAS_Image_d32
#define GLIFT_std_image_HAS_Image_d32
/// Image<d32>. A 2-D image of texel format or type F. `sample` filters it linearly, if texels are floats; its
/// coordinates are in texels, the centre of texel (0, 0) at (0.5, 0.5); beyond the edge the nearest texel counts.
/// Reads outside give zero, writes there go nowhere.
class Image_d32 : public glift::Structure<Image_d32, glift::uint2, float> {
public:
    static constexpr const char* type_name = "Image<d32>";

    Image_d32() = default;
    Image_d32(const glift::Commands& commands, glift::uint2 extent);
    /// Makes the structure with the given memory.
    Image_d32(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    glift::uint2 data_extent() const { return data_extent_; }
    bool same_state(const Image_d32& other) const;

    void copy_out(const glift::Commands& commands, const glift::Range<Image_d32>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint2>;
    static constexpr std::uint64_t state_key = 7500678889632760473u;
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

}  // namespace std_image

namespace draws {

using Depth = ::std_image::Image_d32;

}  // namespace draws

namespace std_array {

#ifndef GLIFT_std_array_HAS_Array_2_uint
#define GLIFT_std_array_HAS_Array_2_uint
/// Array<2, uint>. A dense N-D array. Memory: one element per address; image2d rounds up to whole rows. `edge` says
/// what reads outside give, by default zero; writes outside are discarded. Lefohn's thesis (Glift: Generic Data
/// Structures for Graphics Hardware, 2006), section 9.1.
class Array_2_uint : public glift::Structure<Array_2_uint, glift::uint2, glift::uint> {
public:
    static constexpr const char* type_name = "Array<2, uint>";

    Array_2_uint() = default;
    Array_2_uint(const glift::Commands& commands, glift::uint2 extent);
    /// Makes the structure with the given memory.
    Array_2_uint(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    bool same_state(const Array_2_uint& other) const;

    void fill(glift::uint value);
    void fill(glift::uint value, const glift::Range<Array_2_uint>& range);
    std::uint64_t place(glift::uint2 address) const;
    const glift::Memory& row_memory() const { return data_; }
    void copy_out(const glift::Commands& commands, const glift::Range<Array_2_uint>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Array_2_uint>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint2>;
    static constexpr std::uint64_t state_key = 10746358178786628004u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.buffer("data", data_, data_extent_, glift::uint{});
    }

private:
    glift::uint2 extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_array

namespace draws {

using Counts = ::std_array::Array_2_uint;

/// A mesh, shaded by its flat normals.
void draw_mesh(const glift::Commands& commands, const glift::Range<Corners>& corner, const glift::Range<Points>& points,
    glift::float4x4 camera, const glift::Range<Colour>& colour, const glift::Range<Depth>& depth);

/// Draws the triangles once for each mark (instances), blended over the image.
void draw_marks(const glift::Commands& commands, const glift::Range<Points>& corner, const glift::Range<Points>& mark,
    const glift::Range<Colour>& image, const glift::Range<Depth>& depth);

/// Derivatives of uniform values, which are zero.
void even(const glift::Commands& commands, const glift::Range<Points>& corner, float factor,
    const glift::Range<Colour>& image);

/// Draws are called like kernels.
void frame(const glift::Commands& commands, const Corners& corners, const Points& points, glift::float4x4 camera,
    const Points& marks, const Corners& number, const Colour& image);

}  // namespace draws
