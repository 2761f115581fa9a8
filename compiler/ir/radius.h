// The radius of the window that a kernel reads around an element by `near`.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace gliftc::ir {

/// The largest offset from the window's centre along each axis.
struct Radius {
    std::array<std::uint32_t, 4> along = {};

    std::uint32_t largest() const;
    bool is_even() const;  ///< the same along all axes
    /// Whether the window contains the other one.
    bool covers(const Radius& other) const;
};

/// As the language writes it, for addresses of so many axes: `1`, or `uint2(4, 0)`.
std::string to_text(const Radius&, std::uint32_t axes);

}  // namespace gliftc::ir
