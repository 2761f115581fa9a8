// Made by gliftc from texture_unit.glift. Changes are lost when it is made again.
#pragma once

#include "texture_unit.glift.hpp"

namespace std_transfer {

#ifndef GLIFT_std_transfer_HAS_Box_3_float
#define GLIFT_std_transfer_HAS_Box_3_float
/// Box<3, float>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_3_float : public glift::Structure<Box_3_float, glift::uint3, float> {
public:
    static constexpr const char* type_name = "Box<3, float>";

    Box_3_float() = default;
    Box_3_float(const glift::Commands& commands, glift::uint3 extent);
    /// Makes the structure with the given memory.
    Box_3_float(const glift::Commands& commands, glift::uint3 extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint3 domain() const;
    glift::uint3 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Box_3_float& other) const;

    /// Gives every element, or those of a box, the same value.
    void fill(float value);
    void fill(float value, const glift::Range<Box_3_float>& range);
    /// The index of an element in row_memory(): an affine function of the element's address.
    std::uint64_t place(glift::uint3 address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Copy the elements to a linear buffer, `box`, the first axis fastest, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_3_float>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_3_float>& range,
        const glift::Memory& box) const;

    /// Calls see.value, see.memory, see.member or see.given for each part. glift/inspect.h has such a class.
    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }

private:
    glift::uint3 extent_{};
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

#ifndef GLIFT_std_transfer_HAS_Box_1_float
#define GLIFT_std_transfer_HAS_Box_1_float
/// Box<1, float>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_1_float : public glift::Structure<Box_1_float, glift::uint, float> {
public:
    static constexpr const char* type_name = "Box<1, float>";

    Box_1_float() = default;
    Box_1_float(const glift::Commands& commands, glift::uint extent);
    /// Makes the structure with the given memory.
    Box_1_float(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Box_1_float& other) const;

    /// Gives every element, or those of a box, the same value.
    void fill(float value);
    void fill(float value, const glift::Range<Box_1_float>& range);
    /// The index of an element in row_memory(): an affine function of the element's address.
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Copy the elements to a linear buffer, `box`, the first axis fastest, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_1_float>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_1_float>& range,
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

void read_box_89e7a8a0(const glift::Commands& commands, const glift::Range<::texture_unit::Shadows>& from,
    const glift::Range<Box_3_float>& to);
void read_box_0976d8f6(const glift::Commands& commands, const glift::Range<::texture_unit::Heights>& from,
    const glift::Range<Box_2_float>& to);
void write_box_c1315537(const glift::Commands& commands, const glift::Range<Box_2_float>& from,
    const glift::Range<::texture_unit::Heights>& to);
void fill_box_7c95e848(const glift::Commands& commands, const glift::Range<::texture_unit::Heights>& to, float value);
void read_box_92f4ce80(const glift::Commands& commands,
    const glift::Range<::std_array::Array_2_uint_none_image2d>& from, const glift::Range<Box_2_uint>& to);
void write_box_99148957(const glift::Commands& commands, const glift::Range<Box_2_uint>& from,
    const glift::Range<::std_array::Array_2_uint_none_image2d>& to);
void fill_box_1b4fd378(const glift::Commands& commands, const glift::Range<::std_array::Array_2_uint_none_image2d>& to,
    glift::uint value);
void read_box_f0d3f0af(const glift::Commands& commands,
    const glift::Range<::std_array::Array_1_float3_none_buffer>& from, const glift::Range<Box_1_float3>& to);
void write_box_59b2fb2a(const glift::Commands& commands, const glift::Range<Box_1_float3>& from,
    const glift::Range<::std_array::Array_1_float3_none_buffer>& to);
void fill_box_dfa8b7d0(const glift::Commands& commands, const glift::Range<::std_array::Array_1_float3_none_buffer>& to,
    glift::float3 value);
void read_box_679e2ba9(const glift::Commands& commands,
    const glift::Range<::std_array::Array_1_float_none_buffer>& from, const glift::Range<Box_1_float>& to);
void write_box_7a558d52(const glift::Commands& commands, const glift::Range<Box_1_float>& from,
    const glift::Range<::std_array::Array_1_float_none_buffer>& to);
void fill_box_4fb0cc86(const glift::Commands& commands, const glift::Range<::std_array::Array_1_float_none_buffer>& to,
    float value);

}  // namespace std_transfer
