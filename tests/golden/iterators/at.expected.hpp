// Made by gliftc from at.glift. Changes are lost when it is made again.
#pragma once

#include <glift/glift.h>
#include <glift/structure.h>

#include <cstddef>

/// Addresses without data.
namespace at {

/// Array<2, float, none, buffer>. A dense N-D array. Memory: one element an address. What lies outside is up to
/// `edge`: by default reads give zero and
/// writes go nowhere. Thesis section 9.1.
class Field : public glift::Structure<Field, glift::uint2, float> {
public:
    static constexpr const char* type_name = "Field";

    Field() = default;
    Field(const glift::Commands& commands, glift::uint2 extent);
    /// Over parts that exist already.
    Field(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    glift::uint data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    bool same_state(const Field& other) const;

    /// Gives every element, or those of a box, one value.
    void fill(float value);
    void fill(float value, const glift::Range<Field>& range);
    /// Where an element lies in row_memory(), in elements; the address is an affine function of the virtual one.
    std::uint64_t place(glift::uint2 address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Elements of a box to a linear buffer, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Field>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Field>& range, const glift::Memory& box) const;

private:
    glift::uint2 extent_{};
    glift::uint data_extent_{};
    glift::Memory data_;
};

void ramp(const glift::Commands& commands, const glift::Range<Field>& a, const glift::Range<Field>& f);
void ramp(const glift::Commands& commands, const glift::Range<Field>& f);

}  // namespace at
