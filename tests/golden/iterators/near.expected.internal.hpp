// Made by gliftc from near.glift. Changes are lost when it is made again.
#pragma once

#include "near.glift.hpp"

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

void read_box_6d963c25(const glift::Commands& commands,
    const glift::Range<::std_array::Array_3_float_none_buffer>& from, const glift::Range<Box_3_float>& to);
void write_box_e5b112ea(const glift::Commands& commands, const glift::Range<Box_3_float>& from,
    const glift::Range<::std_array::Array_3_float_none_buffer>& to);
void fill_box_bdadf51c(const glift::Commands& commands, const glift::Range<::std_array::Array_3_float_none_buffer>& to,
    float value);

}  // namespace std_transfer
