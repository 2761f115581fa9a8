// Made by gliftc from near_blocks.glift. Changes are lost when it is made again.
#pragma once

#include "near_blocks.glift.hpp"

namespace std_transfer {

#ifndef GLIFT_std_transfer_HAS_Box_2_float
#define GLIFT_std_transfer_HAS_Box_2_float
/// Box<2, float>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_2_float : public glift::Structure<Box_2_float, glift::uint2, float> {
public:
    static constexpr const char* type_name = "Box<2, float>";

    Box_2_float() = default;
    Box_2_float(const glift::Commands& commands, glift::uint2 extent);
    /// Over parts that exist already.
    Box_2_float(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    bool same_state(const Box_2_float& other) const;

    /// Gives every element, or those of a box, one value.
    void fill(float value);
    void fill(float value, const glift::Range<Box_2_float>& range);
    /// Where an element lies in row_memory(), in elements; the address is an affine function of the virtual one.
    std::uint64_t place(glift::uint2 address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Elements of a box to a linear buffer, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_2_float>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_2_float>& range,
        const glift::Memory& box) const;

private:
    glift::uint2 extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

void read_box_9bb01b1e(const glift::Commands& commands, const glift::Range<::near_blocks::Listed>& from,
    const glift::Range<Box_2_float>& to);
void write_box_bdc9234f(const glift::Commands& commands, const glift::Range<Box_2_float>& from,
    const glift::Range<::near_blocks::Listed>& to);
void fill_box_c2b13d34(const glift::Commands& commands, const glift::Range<::near_blocks::Listed>& to, float value);

}  // namespace std_transfer
