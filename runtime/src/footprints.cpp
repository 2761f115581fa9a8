// Alias analysis of a call's arguments: for parameters that share a memory, whether what they access is disjoint, the
// same element in each invocation, or a race.
#include "objects.h"
#include "text.h"

#include <glift/error.h>
#include <glift/footprint.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace glift::detail {

namespace {

/// Where one of two boxes has more contiguous rows than this, are_apart compares only the ranges from their first to
/// their last byte.
constexpr std::uint64_t most_rows = 1 << 16;

bool writes(const Binding& binding) { return binding.access != Access::read; }

/// The box of virtual addresses that a binding's parameter may access.
Box touched(const Binding& binding, const Footprint& footprint, const Box& visited) {
    Box box = footprint.box;
    if (binding.reach != Reach::window) return box;
    if (footprint.is_whole) box.origin = visited.origin, box.size = visited.size;
    for (unsigned axis = 0; axis < box.rank; ++axis) {
        const std::uint64_t end = std::uint64_t{box.origin[axis]} + box.size[axis] + binding.radius;
        const std::uint32_t begin = box.origin[axis] - std::min(box.origin[axis], binding.radius);
        box.origin[axis] = begin;
        box.size[axis] = static_cast<std::uint32_t>(std::min<std::uint64_t>(end, box.domain[axis]) - begin);
    }
    return box;
}

/// Byte offsets of a box's elements: an affine function of the address.
struct Places {
    std::uint64_t first = 0;
    std::int64_t stride[4] = {};
    std::uint64_t count[4] = {1, 1, 1, 1};
    std::uint64_t width = 0;  ///< bytes of an element; after merge_axes, of a contiguous row of elements

    Places(const Footprint& footprint, const Box& box) : width(footprint.table->element_bytes) {
        const auto place = [&](const Extent& at) { return footprint.table->place(footprint.structure, at) * width; };
        first = place(box.origin);
        for (unsigned axis = 0; axis < box.rank; ++axis) {
            count[axis] = box.size[axis];
            if (box.size[axis] < 2) continue;
            Extent next = box.origin;
            ++next[axis];
            stride[axis] = static_cast<std::int64_t>(place(next) - first);
        }
    }

    bool is_empty() const { return std::ranges::find(count, 0u) != std::end(count); }
    std::uint64_t rows() const { return count[0] * count[1] * count[2] * count[3]; }
    /// The offset of the lowest byte of the elements, and that after their highest byte.
    std::pair<std::uint64_t, std::uint64_t> hull() const {
        std::uint64_t low = first, high = first;
        for (unsigned axis = 0; axis < 4; ++axis) {
            const std::int64_t reach = stride[axis] * static_cast<std::int64_t>(count[axis] - 1);
            (reach < 0 ? low : high) += static_cast<std::uint64_t>(reach);
        }
        return {low, high + width};
    }
    template <class Visit> void for_each_row(Visit&& visit) const {
        for (std::uint64_t w = 0; w < count[3]; ++w)
            for (std::uint64_t z = 0; z < count[2]; ++z)
                for (std::uint64_t y = 0; y < count[1]; ++y)
                    for (std::uint64_t x = 0; x < count[0]; ++x)
                        visit(first + x * static_cast<std::uint64_t>(stride[0]) +
                              y * static_cast<std::uint64_t>(stride[1]) + z * static_cast<std::uint64_t>(stride[2]) +
                              w * static_cast<std::uint64_t>(stride[3]));
    }

    /// Whether it is certain that no two elements overlap: each stride is at least the span of all axes with smaller
    /// strides.
    bool is_one_to_one() const {
        unsigned axes[] = {0, 1, 2, 3};
        std::ranges::sort(axes, {}, [&](unsigned axis) { return std::abs(stride[axis]); });
        std::uint64_t reach = 0;
        for (unsigned axis : axes) {
            if (count[axis] < 2) continue;
            const auto step = static_cast<std::uint64_t>(std::abs(stride[axis]));
            if (step < reach + width) return false;
            reach += step * (count[axis] - 1);
        }
        return true;
    }
    /// Merges axes whose elements are contiguous into one wider element.
    void merge_axes() {
        for (unsigned round = 0; round < 4; ++round) {
            for (unsigned axis = 0; axis < 4; ++axis) {
                if (count[axis] == 1 || stride[axis] != static_cast<std::int64_t>(width)) continue;
                width *= count[axis];
                count[axis] = 1;
            }
        }
    }
};

bool are_apart(Places one, Places other) {
    if (one.is_empty() || other.is_empty()) return true;
    one.merge_axes();
    other.merge_axes();
    const auto [low, high] = one.hull();
    const auto [other_low, other_high] = other.hull();
    if (high <= other_low || other_high <= low) return true;
    if (one.rows() > most_rows || other.rows() > most_rows) return false;
    std::vector<std::uint64_t> rows;
    rows.reserve(one.rows());
    one.for_each_row([&](std::uint64_t first) { rows.push_back(first); });
    std::ranges::sort(rows);
    bool apart = true;
    other.for_each_row([&](std::uint64_t first) {
        // The last row of `one` that begins before this row's end must not reach beyond this row's begin.
        const auto next = std::ranges::lower_bound(rows, first + other.width);
        apart = apart && (next == rows.begin() || *(next - 1) + one.width <= first);
    });
    return apart;
}

Box whole_of(const Footprint& footprint) {
    Box box = footprint.box;
    box.origin = {};
    box.size = box.domain;
    return box;
}

bool is_one_structure(const Footprint& one, const Footprint& other) {
    return one.table == other.table && one.table->same_state(one.structure, other.structure);
}

/// The name of a binding's parameter, as in the source.
std::string parameter_of(const Binding& binding) {
    const std::string_view name = binding.name;
    return std::string(name.substr(0, name.find('.')));
}

std::string touches_text(const Binding& binding, const Box& box) {
    const std::string name = "'" + parameter_of(binding) + "' " + (writes(binding) ? "writes " : "reads ");
    if (binding.reach == Reach::memory) return name + binding.name;
    const std::string where = text_of(box.size, box.rank) + " elements from " + text_of(box.origin, box.rank) + " on";
    switch (binding.reach) {
    case Reach::element: return name + "each of " + where;
    case Reach::window: return name + "windows in " + where;
    case Reach::range:
    case Reach::memory: break;
    }
    return name + "any of " + where;
}

/// The binding's name without that of its parameter: `table.data` of `f.table.data`.
std::string_view within_parameter(const Binding& binding) {
    const std::string_view name = binding.name;
    return name.substr(name.find('.') + 1);
}

/// Two bindings of the same memory, or of images with texels in common.
struct Pair {
    const Kernel& kernel;
    std::span<const Memory> memories;
    const Binding &one, &other;
    const Footprint &first, &second;
    const Box& visited;

    bool is_one_place() const {
        return one.reach == Reach::element && other.reach == Reach::element && is_one_structure(first, second) &&
               first.box.origin == second.box.origin && first.box.size == second.box.size && have_one_translation();
    }
    /// Whether both parameters' addresses are translated with the same memories: each one that the translator of the
    /// first reads, such as a page table, is bound for the second under the same name.
    bool have_one_translation() const {
        for (std::size_t i = 0; i < memories.size(); ++i) {
            const Binding& table = kernel.bindings[i];
            if (table.parameter != one.parameter || table.reach != Reach::memory) continue;
            const auto is_its = [&](const Binding& binding) {
                return binding.parameter == other.parameter && within_parameter(binding) == within_parameter(table);
            };
            const auto of_other = std::ranges::find_if(kernel.bindings, is_its);
            if (of_other == kernel.bindings.end()) return false;
            const auto k = static_cast<std::size_t>(of_other - kernel.bindings.begin());
            if (memories[k].object() != memories[i].object()) return false;
        }
        return true;
    }
    bool has_places() const {
        return one.reach != Reach::memory && other.reach != Reach::memory && first.table->place && second.table->place;
    }
    bool is_apart() const {
        if (!has_places()) return false;
        const Box box = touched(one, first, visited), second_box = touched(other, second, visited);
        if (is_one_structure(first, second) && Places(first, whole_of(first)).is_one_to_one())
            return !box.overlaps(second_box);
        return are_apart(Places(first, box), Places(second, second_box));
    }
    [[noreturn]] void refuse(const Memory& memory) const {
        throw Error(ErrorCode::aliased_memory,
                    "parameters '" + parameter_of(one) + "' and '" + parameter_of(other) +
                        "' were given one memory, and one invocation may write what another touches",
                    kernel_text(kernel) + ", " + memory_text(memory.description()),
                    touches_text(one, touched(one, first, visited)) + ", " +
                        touches_text(other, touched(other, second, visited)) +
                        (has_places() ? ""
                                      : "; whether these overlap is not known, since their translators are not "
                                        "known to be affine maps that stay inside a buffer"),
                    "write into another structure, then copy or swap; boxes of an array in a buffer that do not "
                    "overlap may be passed, and one box for several 'each' parameters");
    }
};

}  // namespace

bool is_shared(const Kernel& kernel, std::span<const Memory> memories) {
    for (std::size_t k = 1; k < memories.size(); ++k) {
        for (std::size_t j = 0; j < k; ++j) {
            const bool is_one = memories[j].object() && shares_texels(memories[j].object(), memories[k].object());
            if (is_one && (writes(kernel.bindings[j]) || writes(kernel.bindings[k]))) return true;
        }
    }
    return false;
}

Sharing compare_footprints(const Kernel& kernel, std::span<const Memory> memories, const Box& visited,
                           std::span<const Footprint> footprints) {
    Sharing sharing = Sharing::apart;
    for (std::size_t k = 1; k < memories.size(); ++k) {
        for (std::size_t j = 0; j < k; ++j) {
            const Binding &one = kernel.bindings[j], &other = kernel.bindings[k];
            if (!writes(one) && !writes(other)) continue;
            if (!shares_texels(memories[j].object(), memories[k].object())) continue;
            if (one.combine != Combine::none && one.combine == other.combine) continue;
            if (one.is_apart_from(other.parameter) || one.has_other_fields(other)) continue;
            const Pair pair{kernel, memories, one, other, footprints[one.parameter], footprints[other.parameter],
                            visited};
            if (pair.is_one_place()) sharing = Sharing::one_place;
            else if (!pair.is_apart()) pair.refuse(memories[k]);
        }
    }
    return sharing;
}

}  // namespace glift::detail
