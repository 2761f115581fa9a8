// How the elements of a dense structure lie in a buffer, plane by plane of the last axis.
#pragma once

#include <glift/range_shape.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

namespace glift::detail {

/// Plane k of the last axis is the bytes [k * plane_bytes, (k + 1) * plane_bytes) of the buffer.
struct SlabLayout {
    static constexpr std::uint32_t farthest = 8;
    static constexpr std::uint32_t nowhere = UINT32_MAX;

    std::uint32_t planes = 0;
    std::uint64_t plane_bytes = 0;
    /// The plane where an address d + 1 planes before the first one, or after the last one, leads.
    std::array<std::uint32_t, farthest> before{}, after{};

    bool operator==(const SlabLayout&) const = default;

    /// Whether addresses before the first plane lead to the last planes.
    bool wraps() const { return before[0] != nowhere && before[0] > planes / 2; }

    /// The plane where an address with this last coordinate leads, or `nowhere`.
    std::uint32_t plane_at(std::int64_t coordinate) const {
        if (coordinate >= 0 && coordinate < planes) return static_cast<std::uint32_t>(coordinate);
        if (coordinate < 0) return before[static_cast<std::size_t>(-coordinate - 1)];
        return after[static_cast<std::size_t>(coordinate - planes)];
    }
};

/// Finds layouts, and remembers those of structures of equal type and extent. A structure has a layout if its elements
/// lie in order: those along an axis a constant distance apart, and no plane within another one. For structures whose
/// indices are not proved to be affine (HasIndices) that is tried for each element of each axis and for 256 others.
class SlabLayouts {
public:
    std::optional<SlabLayout> of(const RangeShape& shape);

private:
    using Key = std::tuple<const void*, unsigned, Extent, std::uint32_t>;
    std::map<Key, std::optional<SlabLayout>> known_;
};

}  // namespace glift::detail
