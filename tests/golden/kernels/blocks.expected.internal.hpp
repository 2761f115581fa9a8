// Made by gliftc from blocks.glift. Changes are lost when it is made again.
#pragma once

#include "blocks.glift.hpp"

namespace std_transfer {

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

#ifndef GLIFT_std_transfer_HAS_Box_1_uint3
#define GLIFT_std_transfer_HAS_Box_1_uint3
/// Box<1, uint3>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_1_uint3 : public glift::Structure<Box_1_uint3, glift::uint, glift::uint3> {
public:
    static constexpr const char* type_name = "Box<1, uint3>";

    Box_1_uint3() = default;
    Box_1_uint3(const glift::Commands& commands, glift::uint extent);
    /// Makes the structure with the given memory.
    Box_1_uint3(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Box_1_uint3& other) const;

    /// Gives every element, or those of a box, the same value.
    void fill(glift::uint3 value);
    void fill(glift::uint3 value, const glift::Range<Box_1_uint3>& range);
    /// The index of an element in row_memory(): an affine function of the element's address.
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Copy the elements to a linear buffer, `box`, the first axis fastest, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_1_uint3>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_1_uint3>& range,
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

#ifndef GLIFT_std_transfer_HAS_Box_1_uint2
#define GLIFT_std_transfer_HAS_Box_1_uint2
/// Box<1, uint2>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_1_uint2 : public glift::Structure<Box_1_uint2, glift::uint, glift::uint2> {
public:
    static constexpr const char* type_name = "Box<1, uint2>";

    Box_1_uint2() = default;
    Box_1_uint2(const glift::Commands& commands, glift::uint extent);
    /// Makes the structure with the given memory.
    Box_1_uint2(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Box_1_uint2& other) const;

    /// Gives every element, or those of a box, the same value.
    void fill(glift::uint2 value);
    void fill(glift::uint2 value, const glift::Range<Box_1_uint2>& range);
    /// The index of an element in row_memory(): an affine function of the element's address.
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Copy the elements to a linear buffer, `box`, the first axis fastest, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_1_uint2>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_1_uint2>& range,
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

}  // namespace std_transfer

namespace blocks {

void blocks_blocks_Listed_2(const glift::Commands& commands, const glift::Range<Listed>& self,
    const glift::Range<::std_transfer::Box_1_uint>& result);

}  // namespace blocks

namespace std_transfer {

void read_box_698f90a1(const glift::Commands& commands, const glift::Range<::std_array::Array_1_uint_none_buffer>& from,
    const glift::Range<Box_1_uint>& to);
void write_box_920b34ba(const glift::Commands& commands, const glift::Range<Box_1_uint>& from,
    const glift::Range<::std_array::Array_1_uint_none_buffer>& to);
void fill_box_fbf6ae12(const glift::Commands& commands, const glift::Range<::std_array::Array_1_uint_none_buffer>& to,
    glift::uint value);
void read_box_a23c245a(const glift::Commands& commands, const glift::Range<::blocks::Listed>& from,
    const glift::Range<Box_3_float>& to);
void write_box_93a8b595(const glift::Commands& commands, const glift::Range<Box_3_float>& from,
    const glift::Range<::blocks::Listed>& to);
void fill_box_blocks_Listed_float(const glift::Commands& commands, const glift::Range<::blocks::Listed>& to,
    float value);
void list_there_b56b1eed(const glift::Commands& commands, const glift::Range<::blocks::Listed>& a,
    const glift::Range<::blocks::Listed>& from, const glift::Range<::blocks::Listed>& translated,
    const glift::Range<Box_1_uint>& counter, const glift::Range<Box_1_uint3>& addresses,
    const glift::Range<Box_1_uint2>& places, const glift::Range<Box_1_float>& values);
void read_box_f3d15695(const glift::Commands& commands,
    const glift::Range<::std_array::Array_2_float_none_buffer>& from, const glift::Range<Box_2_float>& to);
void write_box_d5801374(const glift::Commands& commands, const glift::Range<Box_2_float>& from,
    const glift::Range<::std_array::Array_2_float_none_buffer>& to);
void fill_box_902cb707(const glift::Commands& commands, const glift::Range<::std_array::Array_2_float_none_buffer>& to,
    float value);

}  // namespace std_transfer

namespace blocks {

glift::DeviceScalar<glift::uint> blocks_blocks_Listed(const glift::Commands& commands,
    const glift::Range<Listed>& self);
glift::DeviceScalar<glift::uint> block_count_blocks_Listed(const glift::Commands& commands,
    const glift::Range<Listed>& self);

}  // namespace blocks
