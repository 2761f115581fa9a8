// Made by gliftc from device_values.glift. Changes are lost when it is made again.
#pragma once

#include "device_values.glift.hpp"

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

#ifndef GLIFT_std_transfer_HAS_Box_1_bool
#define GLIFT_std_transfer_HAS_Box_1_bool
/// Box<1, bool>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_1_bool : public glift::Structure<Box_1_bool, glift::uint, glift::Bool> {
public:
    static constexpr const char* type_name = "Box<1, bool>";

    Box_1_bool() = default;
    Box_1_bool(const glift::Commands& commands, glift::uint extent);
    /// Makes the structure with the given memory.
    Box_1_bool(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Box_1_bool& other) const;

    /// Gives every element, or those of a box, the same value.
    void fill(bool value);
    void fill(bool value, const glift::Range<Box_1_bool>& range);
    /// The index of an element in row_memory(): an affine function of the element's address.
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Copy the elements to a linear buffer, `box`, the first axis fastest, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_1_bool>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_1_bool>& range,
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

namespace device_values {

void scale(const glift::Commands& commands, const glift::Range<Line>& a, glift::uint by);

}  // namespace device_values

namespace std_transfer {

void read_box_698f90a1(const glift::Commands& commands, const glift::Range<::std_array::Array_1_uint_none_buffer>& from,
    const glift::Range<Box_1_uint>& to);
void write_box_920b34ba(const glift::Commands& commands, const glift::Range<Box_1_uint>& from,
    const glift::Range<::std_array::Array_1_uint_none_buffer>& to);
void fill_box_fbf6ae12(const glift::Commands& commands, const glift::Range<::std_array::Array_1_uint_none_buffer>& to,
    glift::uint value);

}  // namespace std_transfer

namespace device_values {

void value_a0d1f05f_2(const glift::Commands& commands, const glift::DeviceScalar<glift::uint>& element,
    const glift::DeviceScalar<glift::uint>& element_2, glift::uint by,
    const glift::Range<::std_transfer::Box_1_uint>& result);
void value_324e3ecf_2(const glift::Commands& commands, const glift::DeviceScalar<glift::uint>& n,
    const glift::Range<::std_transfer::Box_1_bool>& result);
void scale_device_by(const glift::Commands& commands, const glift::Range<Line>& a,
    const glift::DeviceScalar<glift::uint>& by);
void value_true_2(const glift::Commands& commands, const glift::Range<::std_transfer::Box_1_bool>& result);
void value_0u_2(const glift::Commands& commands, const glift::Range<::std_transfer::Box_1_uint>& result);
void value_53ad928e_2(const glift::Commands& commands, const glift::DeviceScalar<glift::Bool>& condition,
    const glift::DeviceScalar<glift::uint>& times, const glift::Range<::std_transfer::Box_1_uint>& result);
void value_b207683c_2(const glift::Commands& commands, const glift::DeviceScalar<glift::Bool>& running,
    const glift::DeviceScalar<glift::uint>& element, const glift::DeviceScalar<glift::uint>& times,
    const glift::Range<::std_transfer::Box_1_bool>& result);
void value_7992094a_2(const glift::Commands& commands, const glift::DeviceScalar<glift::Bool>& running,
    const glift::DeviceScalar<glift::uint>& times, const glift::Range<::std_transfer::Box_1_uint>& result);
glift::DeviceScalar<glift::uint> value_a0d1f05f(const glift::Commands& commands,
    glift::DeviceScalar<glift::uint> element, glift::DeviceScalar<glift::uint> element_2, glift::uint by);
glift::DeviceScalar<glift::Bool> value_324e3ecf(const glift::Commands& commands, glift::DeviceScalar<glift::uint> n);
glift::DeviceScalar<glift::Bool> value_true(const glift::Commands& commands);
glift::DeviceScalar<glift::uint> value_0u(const glift::Commands& commands);
glift::DeviceScalar<glift::uint> value_53ad928e(const glift::Commands& commands,
    glift::DeviceScalar<glift::Bool> condition, glift::DeviceScalar<glift::uint> times);
glift::DeviceScalar<glift::Bool> value_b207683c(const glift::Commands& commands,
    glift::DeviceScalar<glift::Bool> running, glift::DeviceScalar<glift::uint> element,
    glift::DeviceScalar<glift::uint> times);
glift::DeviceScalar<glift::uint> value_7992094a(const glift::Commands& commands,
    glift::DeviceScalar<glift::Bool> running, glift::DeviceScalar<glift::uint> times);

}  // namespace device_values
