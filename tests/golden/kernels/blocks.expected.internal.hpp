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
    /// Over parts that exist already.
    Box_1_uint(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    bool same_state(const Box_1_uint& other) const;

    /// Gives every element, or those of a box, one value.
    void fill(glift::uint value);
    void fill(glift::uint value, const glift::Range<Box_1_uint>& range);
    /// Where an element lies in row_memory(), in elements; the address is an affine function of the virtual one.
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Elements of a box to a linear buffer, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_1_uint>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_1_uint>& range,
        const glift::Memory& box) const;

private:
    glift::uint extent_{};
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
    /// Over parts that exist already.
    Box_3_float(const glift::Commands& commands, glift::uint3 extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint3 domain() const;
    glift::uint3 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    bool same_state(const Box_3_float& other) const;

    /// Gives every element, or those of a box, one value.
    void fill(float value);
    void fill(float value, const glift::Range<Box_3_float>& range);
    /// Where an element lies in row_memory(), in elements; the address is an affine function of the virtual one.
    std::uint64_t place(glift::uint3 address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Elements of a box to a linear buffer, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_3_float>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_3_float>& range,
        const glift::Memory& box) const;

private:
    glift::uint3 extent_{};
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

void read_box_a23c245a(const glift::Commands& commands, const glift::Range<::blocks::Listed>& from,
    const glift::Range<Box_3_float>& to);
void write_box_93a8b595(const glift::Commands& commands, const glift::Range<Box_3_float>& from,
    const glift::Range<::blocks::Listed>& to);
void fill_box_blocks_Listed_float(const glift::Commands& commands, const glift::Range<::blocks::Listed>& to,
    float value);

}  // namespace std_transfer

namespace blocks {

glift::DeviceScalar<glift::uint> blocks_blocks_Listed(const glift::Commands& commands,
    const glift::Range<Listed>& self);

}  // namespace blocks
