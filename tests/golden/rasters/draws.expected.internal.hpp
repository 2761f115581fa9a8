// Made by gliftc from draws.glift. Changes are lost when it is made again.
#pragma once

#include "draws.glift.hpp"

namespace std_transfer {

#ifndef GLIFT_std_transfer_HAS_Box_1_float3
#define GLIFT_std_transfer_HAS_Box_1_float3
/// Box<1, float3>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_1_float3 : public glift::Structure<Box_1_float3, glift::uint, glift::float3> {
public:
    static constexpr const char* type_name = "Box<1, float3>";

    Box_1_float3() = default;
    Box_1_float3(const glift::Commands& commands, glift::uint extent);
    /// Makes the structure with the given memory.
    Box_1_float3(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Box_1_float3& other) const;

    /// Gives every element, or those of a box, the same value.
    void fill(glift::float3 value);
    void fill(glift::float3 value, const glift::Range<Box_1_float3>& range);
    /// The index of an element in row_memory(): an affine function of the element's address.
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Copy the elements to a linear buffer, `box`, the first axis fastest, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_1_float3>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_1_float3>& range,
        const glift::Memory& box) const;

    /// Calls see.value, see.memory, see.member or see.given for each part. glift/inspect.h has such a class.
    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }

private:
    glift::uint extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

#ifndef GLIFT_std_transfer_HAS_Box_1_uint
#define GLIFT_std_transfer_HAS_Box_1_uint
/// Box<1, uint>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_1_uint : public glift::Structure<Box_1_uint, glift::uint, glift::uint> {
public:
    static constexpr const char* type_name = "Box<1, uint>";

    Box_1_uint() = default;
    Box_1_uint(const glift::Commands& commands, glift::uint extent);
    /// Makes the structure with the given memory.
    Box_1_uint(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Box_1_uint& other) const;

    /// Gives every element, or those of a box, the same value.
    void fill(glift::uint value);
    void fill(glift::uint value, const glift::Range<Box_1_uint>& range);
    /// The index of an element in row_memory(): an affine function of the element's address.
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Copy the elements to a linear buffer, `box`, the first axis fastest, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_1_uint>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_1_uint>& range,
        const glift::Memory& box) const;

    /// Calls see.value, see.memory, see.member or see.given for each part. glift/inspect.h has such a class.
    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }

private:
    glift::uint extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

#ifndef GLIFT_std_transfer_HAS_Box_2_float4
#define GLIFT_std_transfer_HAS_Box_2_float4
/// Box<2, float4>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_2_float4 : public glift::Structure<Box_2_float4, glift::uint2, glift::float4> {
public:
    static constexpr const char* type_name = "Box<2, float4>";

    Box_2_float4() = default;
    Box_2_float4(const glift::Commands& commands, glift::uint2 extent);
    /// Makes the structure with the given memory.
    Box_2_float4(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Box_2_float4& other) const;

    /// Gives every element, or those of a box, the same value.
    void fill(glift::float4 value);
    void fill(glift::float4 value, const glift::Range<Box_2_float4>& range);
    /// The index of an element in row_memory(): an affine function of the element's address.
    std::uint64_t place(glift::uint2 address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Copy the elements to a linear buffer, `box`, the first axis fastest, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_2_float4>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_2_float4>& range,
        const glift::Memory& box) const;

    /// Calls see.value, see.memory, see.member or see.given for each part. glift/inspect.h has such a class.
    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }

private:
    glift::uint2 extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

#ifndef GLIFT_std_transfer_HAS_Box_2_float
#define GLIFT_std_transfer_HAS_Box_2_float
/// Box<2, float>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_2_float : public glift::Structure<Box_2_float, glift::uint2, float> {
public:
    static constexpr const char* type_name = "Box<2, float>";

    Box_2_float() = default;
    Box_2_float(const glift::Commands& commands, glift::uint2 extent);
    /// Makes the structure with the given memory.
    Box_2_float(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Box_2_float& other) const;

    /// Gives every element, or those of a box, the same value.
    void fill(float value);
    void fill(float value, const glift::Range<Box_2_float>& range);
    /// The index of an element in row_memory(): an affine function of the element's address.
    std::uint64_t place(glift::uint2 address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Copy the elements to a linear buffer, `box`, the first axis fastest, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_2_float>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_2_float>& range,
        const glift::Memory& box) const;

    /// Calls see.value, see.memory, see.member or see.given for each part. glift/inspect.h has such a class.
    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }

private:
    glift::uint2 extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

#ifndef GLIFT_std_transfer_HAS_Box_2_uint
#define GLIFT_std_transfer_HAS_Box_2_uint
/// Box<2, uint>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_2_uint : public glift::Structure<Box_2_uint, glift::uint2, glift::uint> {
public:
    static constexpr const char* type_name = "Box<2, uint>";

    Box_2_uint() = default;
    Box_2_uint(const glift::Commands& commands, glift::uint2 extent);
    /// Makes the structure with the given memory.
    Box_2_uint(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Box_2_uint& other) const;

    /// Gives every element, or those of a box, the same value.
    void fill(glift::uint value);
    void fill(glift::uint value, const glift::Range<Box_2_uint>& range);
    /// The index of an element in row_memory(): an affine function of the element's address.
    std::uint64_t place(glift::uint2 address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Copy the elements to a linear buffer, `box`, the first axis fastest, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_2_uint>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_2_uint>& range,
        const glift::Memory& box) const;

    /// Calls see.value, see.memory, see.member or see.given for each part. glift/inspect.h has such a class.
    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }

private:
    glift::uint2 extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_transfer

namespace std_image {

#ifndef GLIFT_std_image_HAS_Everything
#define GLIFT_std_image_HAS_Everything
/// The numbers of the three corners of a triangle that covers the whole viewport.
class Everything : public glift::View<Everything, glift::uint, glift::uint> {
public:
    static constexpr const char* type_name = "Everything";

    Everything() = default;
    explicit Everything(glift::uint count);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint count() const { return count_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Everything& other) const;

    /// Copies the elements to a linear buffer, `box`, the first axis fastest.
    void copy_out(const glift::Commands& commands, const glift::Range<Everything>& range,
        const glift::Memory& box) const;

    /// Calls see.value, see.memory, see.member or see.given for each part. glift/inspect.h has such a class.
    template <class See> void describe(See&& see) const {
        see.value("count", count_);
    }

private:
    glift::uint count_{};
};
#endif

}  // namespace std_image

namespace std_transfer {

void read_box_9d8f71b4(const glift::Commands& commands, const glift::Range<::std_image::Image_d32>& from,
    const glift::Range<Box_2_float>& to);

}  // namespace std_transfer

namespace std_image {

void draw_depth_19ff2775(const glift::Commands& commands, const glift::Range<Everything>& corner,
    const glift::Range<Image_d32>& z, float depth);

}  // namespace std_image

namespace std_transfer {

void read_box_698f90a1(const glift::Commands& commands, const glift::Range<::std_array::Array_1_uint_none_buffer>& from,
    const glift::Range<Box_1_uint>& to);
void write_box_920b34ba(const glift::Commands& commands, const glift::Range<Box_1_uint>& from,
    const glift::Range<::std_array::Array_1_uint_none_buffer>& to);
void fill_box_fbf6ae12(const glift::Commands& commands, const glift::Range<::std_array::Array_1_uint_none_buffer>& to,
    glift::uint value);
void read_box_f0d3f0af(const glift::Commands& commands,
    const glift::Range<::std_array::Array_1_float3_none_buffer>& from, const glift::Range<Box_1_float3>& to);
void write_box_59b2fb2a(const glift::Commands& commands, const glift::Range<Box_1_float3>& from,
    const glift::Range<::std_array::Array_1_float3_none_buffer>& to);
void fill_box_dfa8b7d0(const glift::Commands& commands, const glift::Range<::std_array::Array_1_float3_none_buffer>& to,
    glift::float3 value);
void read_box_d09c6321(const glift::Commands& commands, const glift::Range<::std_image::Image_rgba8>& from,
    const glift::Range<Box_2_float4>& to);
void write_box_c92d8b24(const glift::Commands& commands, const glift::Range<Box_2_float4>& from,
    const glift::Range<::std_image::Image_rgba8>& to);
void fill_box_9f341825(const glift::Commands& commands, const glift::Range<::std_image::Image_rgba8>& to,
    glift::float4 value);
void read_box_61c1abfb(const glift::Commands& commands, const glift::Range<::std_array::Array_2_uint_none_buffer>& from,
    const glift::Range<Box_2_uint>& to);
void write_box_522c64c2(const glift::Commands& commands, const glift::Range<Box_2_uint>& from,
    const glift::Range<::std_array::Array_2_uint_none_buffer>& to);
void fill_box_fa7e631f(const glift::Commands& commands, const glift::Range<::std_array::Array_2_uint_none_buffer>& to,
    glift::uint value);

}  // namespace std_transfer

namespace std_image {

void clear_depth_89866a9c(const glift::Commands& commands, const Image_d32& z, float depth);

}  // namespace std_image
