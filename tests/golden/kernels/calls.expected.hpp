// Made by gliftc from calls.glift. Changes are lost when it is made again.
#pragma once

#include "calls.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

/// Functions of a container that write its members, called from a kernel: one binding for each member that they
/// name.

namespace std_array {

#ifndef GLIFT_std_array_HAS_Array_1_uint
#define GLIFT_std_array_HAS_Array_1_uint
/// Array<1, uint>. A dense N-D array. Memory: one element per address; image2d rounds up to whole rows. `edge` says
/// what reads outside give, by default zero; writes outside are discarded. Lefohn's thesis (Glift: Generic Data
/// Structures for Graphics Hardware, 2006), section 9.1.
class Array_1_uint : public glift::Structure<Array_1_uint, glift::uint, glift::uint> {
public:
    static constexpr const char* type_name = "Array<1, uint>";

    Array_1_uint() = default;
    Array_1_uint(const glift::Commands& commands, glift::uint extent);
    /// Makes the structure with the given memory.
    Array_1_uint(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    bool same_state(const Array_1_uint& other) const;

    void fill(glift::uint value);
    void fill(glift::uint value, const glift::Range<Array_1_uint>& range);
    std::uint64_t place(glift::uint address) const;
    const glift::Memory& row_memory() const { return data_; }
    void copy_out(const glift::Commands& commands, const glift::Range<Array_1_uint>& range,
        const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Array_1_uint>& range,
        const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint>;
    static constexpr std::uint64_t state_key = 15592328566153615568u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.buffer("data", data_, data_extent_, glift::uint{});
    }

private:
    glift::uint extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

}  // namespace std_array

namespace calls {

using Line = ::std_array::Array_1_uint;

#ifndef GLIFT_calls_HAS_Bag
#define GLIFT_calls_HAS_Bag
/// Bag, calls.glift:8.
class Bag {
public:
    static constexpr const char* type_name = "Bag";

    Bag() = default;
    Bag(const glift::Commands& commands, glift::uint capacity);

    const glift::Device& device() const {
        if (!device_) glift::detail::throw_empty_structure(type_name, "device");
        return device_;
    }
    glift::uint capacity() const { return capacity_; }
    const Line& items() const { return items_.get(); }
    Line& items() { return items_.get(); }
    const Line& top() const { return top_.get(); }
    Line& top() { return top_.get(); }
    const Line& seen() const { return seen_.get(); }
    Line& seen() { return seen_.get(); }
    bool same_state(const Bag& other) const;

    template <class See> void describe(See&& see) const {
        see.value("capacity", capacity_);
        see.value("limit", limit());
        see.member("items", items());
        see.member("top", top());
        see.member("seen", seen());
    }
    using Arguments = glift::Types<glift::uint>;
    static constexpr std::uint64_t state_key = 17014040237318753225u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("capacity", capacity_);
        visit.member("items", items_.get());
        visit.member("top", top_.get());
        visit.member("seen", seen_.get());
    }

    glift::uint limit() const;

private:
    glift::Device device_;
    glift::uint capacity_{};
    glift::Shared<Line> items_;
    glift::Shared<Line> top_;
    glift::Shared<Line> seen_;
};
#endif

void push_even(const glift::Commands& commands, const glift::Range<Line>& x, const Bag& bag,
    const glift::Range<Line>& lost);

}  // namespace calls
