#include "slab_layout.h"

namespace glift::detail {

namespace {

struct Strides {
    std::uint64_t of[4] = {};
    bool are_constant = true;
};

std::uint64_t index_at(const RangeShape& shape, const Extent& address) {
    return shape.indices.index(shape.indices.structure, address);
}

Strides strides_of(const RangeShape& shape) {
    Strides strides;
    for (unsigned axis = 0; axis < shape.rank; ++axis) {
        Extent at{};
        std::uint64_t last = index_at(shape, at);
        for (at[axis] = 1; at[axis] < shape.domain[axis]; ++at[axis]) {
            const std::uint64_t next = index_at(shape, at);
            if (at[axis] == 1) strides.of[axis] = next - last;
            if (next - last != strides.of[axis]) strides.are_constant = false;
            last = next;
        }
    }
    return strides;
}

bool is_sum_of(const RangeShape& shape, const Strides& strides) {
    std::uint64_t random = 88172645463325252u;
    for (int sample = 0; sample < 256; ++sample) {
        Extent at{};
        std::uint64_t expected = 0;
        for (unsigned axis = 0; axis < shape.rank; ++axis) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            at[axis] = static_cast<std::uint32_t>((random >> 33) % shape.domain[axis]);
            expected += at[axis] * strides.of[axis];
        }
        if (index_at(shape, at) != expected) return false;
    }
    return true;
}

std::optional<SlabLayout> found(const RangeShape& shape) {
    const unsigned last = shape.rank - 1;
    if (!shape.indices.index || volume_of(shape.domain) == 0) return std::nullopt;
    const Strides strides = strides_of(shape);
    std::uint64_t elements_of_plane = 1;
    for (unsigned axis = 0; axis < last; ++axis) elements_of_plane *= shape.domain[axis];
    if (shape.domain[last] < 2 || !strides.are_constant || !is_sum_of(shape, strides)) return std::nullopt;
    if (strides.of[last] != elements_of_plane) return std::nullopt;
    SlabLayout layout{.planes = shape.domain[last], .plane_bytes = elements_of_plane * shape.element_bytes};
    if (layout.plane_bytes % 4 != 0) return std::nullopt;
    const auto plane_of = [&](std::uint32_t coordinate) {
        Extent at{};
        at[last] = coordinate;
        const std::uint64_t plane = index_at(shape, at) / elements_of_plane;
        return plane < layout.planes ? static_cast<std::uint32_t>(plane) : SlabLayout::nowhere;
    };
    for (std::uint32_t d = 0; d < SlabLayout::farthest; ++d) {
        layout.before[d] = plane_of(0u - (d + 1));
        layout.after[d] = plane_of(layout.planes + d);
    }
    return layout;
}

}  // namespace

std::optional<SlabLayout> SlabLayouts::of(const RangeShape& shape) {
    const Key key{reinterpret_cast<const void*>(shape.indices.index), shape.rank, shape.domain, shape.element_bytes};
    const auto at = known_.find(key);
    if (at != known_.end()) return at->second;
    return known_.emplace(key, found(shape)).first->second;
}

}  // namespace glift::detail
