#include "ir/radius.h"

#include <algorithm>

namespace gliftc::ir {

std::uint32_t Radius::largest() const { return *std::max_element(along.begin(), along.end()); }

bool Radius::is_even() const {
    return std::ranges::all_of(along, [&](std::uint32_t part) { return part == along[0]; });
}

bool Radius::covers(const Radius& other) const {
    return std::equal(along.begin(), along.end(), other.along.begin(),
                      [](std::uint32_t mine, std::uint32_t its) { return its <= mine; });
}

std::string to_text(const Radius& radius, std::uint32_t axes) {
    if (radius.is_even() || axes == 1) return std::to_string(radius.along[0]);
    std::string parts;
    for (std::uint32_t axis = 0; axis < axes; ++axis) parts += (axis ? ", " : "") + std::to_string(radius.along[axis]);
    return "uint" + std::to_string(axes) + "(" + parts + ")";
}

}  // namespace gliftc::ir
