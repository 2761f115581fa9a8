// Made by gliftc from devices.glift. Changes are lost when it is made again.
#pragma once

#include <glift/glift.h>
#include <glift/structure.h>

#include <cstddef>

/// Which kernels the host device comes to: only these have a form for it.
namespace devices {

/// Array<1, uint, none, buffer>. A dense N-D array. Memory: one element an address. What lies outside is up to
/// `edge`: by default reads give zero and
/// writes go nowhere. Thesis section 9.1.
class Line : public glift::Structure<Line, glift::uint, glift::uint> {
public:
    static constexpr const char* type_name = "Line";

    Line() = default;
    Line(const glift::Commands& commands, glift::uint extent);
    /// Over parts that exist already.
    Line(const glift::Commands& commands, glift::uint extent, glift::Memory data);

    /// The extent of the virtual domain.
    glift::uint domain() const;
    glift::uint extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    glift::uint data_extent() const { return data_extent_; }
    /// True if the two were made with equal arguments.
    bool same_state(const Line& other) const;

private:
    glift::uint extent_{};
    glift::uint data_extent_{};
    glift::Memory data_;
};

void fill(const glift::Commands& commands, const Line& to, bool many);

}  // namespace devices
