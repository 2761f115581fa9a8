// Made by gliftc from at.glift. Changes are lost when it is made again.
#pragma once

#include "at.glift.hpp"

namespace std_transfer {

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

void read_box_f3d15695(const glift::Commands& commands,
    const glift::Range<::std_array::Array_2_float_none_buffer>& from, const glift::Range<Box_2_float>& to);
void write_box_d5801374(const glift::Commands& commands, const glift::Range<Box_2_float>& from,
    const glift::Range<::std_array::Array_2_float_none_buffer>& to);
void fill_box_902cb707(const glift::Commands& commands, const glift::Range<::std_array::Array_2_float_none_buffer>& to,
    float value);

}  // namespace std_transfer
