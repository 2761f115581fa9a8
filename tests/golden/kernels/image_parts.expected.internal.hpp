// Made by gliftc from image_parts.glift. Changes are lost when it is made again.
#pragma once

#include "image_parts.glift.hpp"

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

#ifndef GLIFT_std_transfer_HAS_Box_3_float4
#define GLIFT_std_transfer_HAS_Box_3_float4
/// Box<3, float4>. Elements of a box in a linear buffer, first axis fastest: what the host reads and writes.
class Box_3_float4 : public glift::Structure<Box_3_float4, glift::uint3, glift::float4> {
public:
    static constexpr const char* type_name = "Box<3, float4>";

    Box_3_float4() = default;
    Box_3_float4(const glift::Commands& commands, glift::uint3 extent);
    /// Makes the structure with the given memory.
    Box_3_float4(const glift::Commands& commands, glift::uint3 extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint3 domain() const;
    glift::uint3 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    /// Whether constructor values and the state of the parts are equal; kernels may then use the sizes of one for both.
    bool same_state(const Box_3_float4& other) const;

    /// Gives every element, or those of a box, the same value.
    void fill(glift::float4 value);
    void fill(glift::float4 value, const glift::Range<Box_3_float4>& range);
    /// The index of an element in row_memory(): an affine function of the element's address.
    std::uint64_t place(glift::uint3 address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Copy the elements to a linear buffer, `box`, the first axis fastest, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Box_3_float4>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Box_3_float4>& range,
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

void read_box_a6033574(const glift::Commands& commands, const glift::Range<::std_image::ImageLevel_r32f>& from,
    const glift::Range<Box_2_float>& to);
void write_box_7baf3dcd(const glift::Commands& commands, const glift::Range<Box_2_float>& from,
    const glift::Range<::std_image::ImageLevel_r32f>& to);
void fill_box_2b12c936(const glift::Commands& commands, const glift::Range<::std_image::ImageLevel_r32f>& to,
    float value);
void read_box_ead0b93f(const glift::Commands& commands, const glift::Range<::std_image::ImageLevels_r32f>& from,
    const glift::Range<Box_2_float>& to);
void write_box_3c321d3e(const glift::Commands& commands, const glift::Range<Box_2_float>& from,
    const glift::Range<::std_image::ImageLevels_r32f>& to);
void fill_box_8cc295b1(const glift::Commands& commands, const glift::Range<::std_image::ImageLevels_r32f>& to,
    float value);
void read_box_184e6050(const glift::Commands& commands, const glift::Range<::std_image::ImageLayers_rgba8>& from,
    const glift::Range<Box_3_float4>& to);
void write_box_424b54b5(const glift::Commands& commands, const glift::Range<Box_3_float4>& from,
    const glift::Range<::std_image::ImageLayers_rgba8>& to);
void fill_box_06059ad3(const glift::Commands& commands, const glift::Range<::std_image::ImageLayers_rgba8>& to,
    glift::float4 value);
void read_box_9ab1f796(const glift::Commands& commands, const glift::Range<::std_image::ImageLayer_rgba8>& from,
    const glift::Range<Box_2_float4>& to);
void write_box_fc1ef9a5(const glift::Commands& commands, const glift::Range<Box_2_float4>& from,
    const glift::Range<::std_image::ImageLayer_rgba8>& to);
void fill_box_673f66ca(const glift::Commands& commands, const glift::Range<::std_image::ImageLayer_rgba8>& to,
    glift::float4 value);

}  // namespace std_transfer
