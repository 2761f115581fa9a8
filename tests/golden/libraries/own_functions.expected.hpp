// Made by gliftc from own_functions.glift. Changes are lost when it is made again.
#pragma once

#include "own_functions.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

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

namespace own_functions {

#ifndef GLIFT_own_functions_HAS_Heights
#define GLIFT_own_functions_HAS_Heights
/// Heights, own_functions.glift:7.
class Heights : public glift::Structure<Heights, glift::uint2, float> {
public:
    static constexpr const char* type_name = "Heights";

    Heights() = default;
    Heights(const glift::Commands& commands, glift::uint side);
    /// Makes the structure with the given nested structures.
    Heights(const glift::Commands& commands, glift::uint side, ::std_array::Array_1_uint asked,
        ::std_array::Array_2_float heights);

    glift::uint2 domain() const;
    glift::uint side() const { return side_; }
    const ::std_array::Array_1_uint& asked() const { return asked_; }
    const ::std_array::Array_2_float& heights() const { return heights_; }
    ::std_array::Array_2_float& heights() { return heights_; }
    bool same_state(const Heights& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<Heights>& range);
    std::uint64_t place(glift::uint2 address) const;
    const glift::Memory& row_memory() const { return heights_.row_memory(); }
    void copy_out(const glift::Commands& commands, const glift::Range<Heights>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Heights>& range, const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("side", side_);
        see.member("asked", asked());
        see.memory("heights", heights());
    }
    using Arguments = glift::Types<glift::uint>;
    static constexpr std::uint64_t state_key = 6150493028458685732u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("side", side_);
        visit.member("asked", asked_);
        visit.base("heights", heights_);
    }

private:
    glift::uint side_{};
    ::std_array::Array_1_uint asked_;
    ::std_array::Array_2_float heights_;
};
#endif

}  // namespace own_functions

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

namespace own_functions {

#ifndef GLIFT_own_functions_HAS_Picture
#define GLIFT_own_functions_HAS_Picture
/// An image that the library writes cannot be filtered: its own `sample` is left out.
class Picture : public glift::Structure<Picture, glift::uint2, glift::float4> {
public:
    static constexpr const char* type_name = "Picture";

    Picture() = default;
    Picture(const glift::Commands& commands, glift::uint2 extent);
    /// Makes the structure with the given nested structures.
    Picture(const glift::Commands& commands, glift::uint2 extent, ::std_image::Image_rgba8 texels);

    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const ::std_image::Image_rgba8& texels() const { return texels_; }
    ::std_image::Image_rgba8& texels() { return texels_; }
    bool same_state(const Picture& other) const;

    void fill(glift::float4 value);
    void fill(glift::float4 value, const glift::Range<Picture>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<Picture>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Picture>& range, const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("texels", texels());
    }
    using Arguments = glift::Types<glift::uint2>;
    static constexpr std::uint64_t state_key = 13996489731618069798u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.base("texels", texels_);
    }

private:
    glift::uint2 extent_{};
    ::std_image::Image_rgba8 texels_;
};
#endif

}  // namespace own_functions
