// Made by gliftc from coherent.glift. Changes are lost when it is made again.
#pragma once

#include "coherent.glift.hpp"

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

void read_box_698f90a1(const glift::Commands& commands, const glift::Range<::std_array::Array_1_uint_none_buffer>& from,
    const glift::Range<Box_1_uint>& to);
void write_box_920b34ba(const glift::Commands& commands, const glift::Range<Box_1_uint>& from,
    const glift::Range<::std_array::Array_1_uint_none_buffer>& to);
void fill_box_fbf6ae12(const glift::Commands& commands, const glift::Range<::std_array::Array_1_uint_none_buffer>& to,
    glift::uint value);

}  // namespace std_transfer
