// Made by gliftc from guards.glift. Changes are lost when it is made again.
#pragma once

#include <glift/glift.h>
#include <glift/structure.h>

#include <cstddef>

/// Guards in loops: on the host one test before the loops stands for those that a loop's variable and constants
/// reach.
namespace guards {

/// Array<1, uint, none, buffer>. A dense N-D array. Memory: one element an address. What lies outside is up to
/// `edge`: by default reads give zero and
/// writes go nowhere. Thesis section 9.1.
class Values : public glift::Structure<Values, glift::uint, glift::uint> {
public:
    static constexpr const char* type_name = "Values";

    Values() = default;
    Values(const glift::Commands& commands, glift::uint extent);
    /// Over parts that exist already.
    Values(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    glift::uint data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    bool same_state(const Values& other) const;

    /// Gives every element, or those of a box, one value.
    void fill(glift::uint value);
    void fill(glift::uint value, const glift::Range<Values>& range);
    /// Where an element lies in row_memory(), in elements; the address is an affine function of the virtual one.
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    /// Elements of a box to a linear buffer, and back.
    void copy_out(const glift::Commands& commands, const glift::Range<Values>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Values>& range, const glift::Memory& box) const;

private:
    glift::uint extent_{};
    glift::uint data_extent_{};
    glift::Memory data_;
};

void double_tiles(const glift::Commands& commands, const glift::Range<Values>& tile, const glift::Range<Values>& from,
    const glift::Range<Values>& to);
void double_tiles(const glift::Commands& commands, const glift::Range<Values>& from, const glift::Range<Values>& to);

/// Element by element; what `far` says is not known before.
void add_far(const glift::Commands& commands, const glift::Range<Values>& tile, const glift::Range<Values>& from,
    glift::uint far_, const glift::Range<Values>& to);
void add_far(const glift::Commands& commands, const glift::Range<Values>& from, glift::uint far_,
    const glift::Range<Values>& to);

}  // namespace guards
