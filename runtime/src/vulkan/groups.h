// Maps an iteration size to workgroups, as kernel.h specifies; prepare_indirect.comp does the same on the device.
#pragma once

#include <glift/pass.h>

#include <algorithm>
#include <array>
#include <bit>

namespace glift::detail {

struct Groups {
    std::array<std::uint64_t, 3> count;

    bool none() const { return !count[0] || !count[1] || !count[2]; }
    bool within(const std::array<std::uint32_t, 3>& limit) const {
        return count[0] <= limit[0] && count[1] <= limit[1] && count[2] <= limit[2];
    }
};

inline std::uint64_t div_ceil(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

/// The elements that a workgroup covers along each axis.
inline std::array<std::uint32_t, 3> covered_by_group(const Kernel& kernel) {
    return {kernel.group[0] * kernel.items[0], kernel.group[1] * kernel.items[1], kernel.group[2] * kernel.items[2]};
}

/// The workgroups of an iteration, before folding.
inline Groups count_groups(const Kernel& kernel, const std::array<std::uint32_t, 4>& size) {
    const std::array<std::uint32_t, 3> covered = covered_by_group(kernel);
    return {{div_ceil(size[0], covered[0]), div_ceil(size[1], covered[1]),
             div_ceil(std::uint64_t(size[2]) * size[3], covered[2])}};
}

/// For kernels over blocks: if there are more than `limit` workgroups along y, spreads them over y and z.
inline void fold_blocks(Groups& groups, std::uint32_t limit) {
    if (groups.count[1] <= limit) return;
    groups.count[2] = div_ceil(groups.count[1], limit);
    groups.count[1] = div_ceil(groups.count[1], groups.count[2]);
}

/// The most workgroups along x of a one-dimensional iteration, on a device that allows `limit`. They have fewer than
/// 2^31 invocations, since the top bit of an invocation's number along x must not be set (unknown_bit.h).
inline std::uint32_t limit_along_x(const Kernel& kernel, std::uint32_t limit) {
    return std::min(limit, 0x7fffffffu / kernel.group[0]);
}

/// Folds a one-dimensional iteration with too many groups along x into two dimensions. The number of rows is a power of
/// two: if a group covers a power of two elements, too, all groups, the surplus ones of the last row included, cover at
/// most 2^32 elements, so that no element's number wraps around.
inline void fold(Groups& groups, std::uint32_t limit) {
    if (groups.count[0] <= limit) return;
    groups.count[1] = std::bit_ceil(div_ceil(groups.count[0], limit));
    groups.count[0] = div_ceil(groups.count[0], groups.count[1]);
}

}  // namespace glift::detail
