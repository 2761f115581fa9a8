// Made by gliftc from own_functions.glift. Changes are lost when it is made again.
#include "own_functions.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace own_functions {

using namespace glift::types;

Heights::Heights(const glift::Commands& commands, uint side)
    : Structure(commands.device()),
      side_(side),
      asked_(::std_array::Array_1_uint(commands, side_)),
      heights_(::std_array::Array_2_float(commands, uint2(side_, side_))) {}

Heights::Heights(const glift::Commands& commands, uint side, ::std_array::Array_1_uint asked,
    ::std_array::Array_2_float heights)
    : Structure(commands.device()),
      side_(side),
      asked_(glift::detail::part(std::move(asked), asked.extent() == side_, "Heights.asked")),
      heights_(glift::detail::part(std::move(heights), heights.extent() == uint2(side_, side_), "Heights.heights")) {}

uint2 Heights::domain() const {
    return heights_.domain();
}

bool Heights::same_state(const Heights& other) const {
    return side_ == other.side_ && asked_.same_state(other.asked_) && heights_.same_state(other.heights_);
}

std::uint64_t Heights::place(uint2 address) const {
    return heights_.place(address);
}

void Heights::copy_out(const glift::Commands& commands, const glift::Range<Heights>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_0490e530(commands, range, ::std_transfer::Box_2_float(commands, range.size(), box));
}

void Heights::copy_in(const glift::Commands& commands, const glift::Range<Heights>& range,
    const glift::Memory& box) const {
    ::std_transfer::write_box_5722ce51(commands, ::std_transfer::Box_2_float(commands, range.size(), box), range);
}

void Heights::fill(float value, const glift::Range<Heights>& range) {
    ::std_transfer::fill_box_90871d1c(device(), range, value);
}
void Heights::fill(float value) {
    fill(value, *this);
}

Picture::Picture(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      texels_(::std_image::Image_rgba8(commands, extent_)) {}

Picture::Picture(const glift::Commands& commands, uint2 extent, ::std_image::Image_rgba8 texels)
    : Structure(commands.device()),
      extent_(extent),
      texels_(glift::detail::part(std::move(texels), texels.extent() == extent_, "Picture.texels")) {}

uint2 Picture::domain() const {
    return texels_.domain();
}

bool Picture::same_state(const Picture& other) const {
    return extent_ == other.extent_ && texels_.same_state(other.texels_);
}

void Picture::copy_out(const glift::Commands& commands, const glift::Range<Picture>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_55cdabb6(commands, range, ::std_transfer::Box_2_float4(commands, range.size(), box));
}

void Picture::copy_in(const glift::Commands& commands, const glift::Range<Picture>& range,
    const glift::Memory& box) const {
    ::std_transfer::write_box_ec9cdc91(commands, ::std_transfer::Box_2_float4(commands, range.size(), box), range);
}

void Picture::fill(float4 value, const glift::Range<Picture>& range) {
    ::std_transfer::fill_box_2367fabe(device(), range, value);
}
void Picture::fill(float4 value) {
    fill(value, *this);
}

}  // namespace own_functions
