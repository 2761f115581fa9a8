// Made by gliftc from composed.glift. Changes are lost when it is made again.
#include "composed.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace composed {

using namespace glift::types;

namespace {
struct copy_direct_parameters {
    uint2 f_extent;
};
static_assert(offsetof(copy_direct_parameters, f_extent) == 0);
struct copy_general_parameters {
    uint2 size;
    uint2 f_origin;
    uint2 g_origin;
    uint f_extent_y;
    uint g_extent_y;
};
static_assert(offsetof(copy_general_parameters, size) == 0);
static_assert(offsetof(copy_general_parameters, f_origin) == 8);
static_assert(offsetof(copy_general_parameters, g_origin) == 16);
static_assert(offsetof(copy_general_parameters, f_extent_y) == 24);
static_assert(offsetof(copy_general_parameters, g_extent_y) == 28);
struct copy_wide_parameters {
    uint2 size;
    uint2 f_origin;
    uint2 g_origin;
    uint3 base;
    std::uint64_t f_extent_y;
    std::uint64_t g_extent_y;
    std::uint64_t f_data_address;
    std::uint64_t g_data_address;
};
static_assert(offsetof(copy_wide_parameters, size) == 0);
static_assert(offsetof(copy_wide_parameters, f_origin) == 8);
static_assert(offsetof(copy_wide_parameters, g_origin) == 16);
static_assert(offsetof(copy_wide_parameters, base) == 24);
static_assert(offsetof(copy_wide_parameters, f_extent_y) == 40);
static_assert(offsetof(copy_wide_parameters, g_extent_y) == 48);
static_assert(offsetof(copy_wide_parameters, f_data_address) == 56);
static_assert(offsetof(copy_wide_parameters, g_data_address) == 64);
}  // namespace

extern const glift::Kernel copy_kernel;

void copy(const glift::Commands& commands, const glift::Range<Turned>& f, const glift::Range<Turned>& g) {
    glift::Iteration iteration(copy_kernel);
    iteration.each("f", f);
    iteration.each("g", g);
    const glift::Memory memories[] = {f->data(), g->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (commands.needs_wide(copy_kernel, memories, iteration.size(), iteration.sharing())) {
        const copy_wide_parameters parameters = {
            .size = f.size(),
            .f_origin = f.origin(),
            .g_origin = g.origin(),
            .base = {},
            .f_extent_y = std::uint64_t(f->extent().y),
            .g_extent_y = std::uint64_t(g->extent().y),
            .f_data_address = 0u,
            .g_data_address = 0u,
        };
        commands.dispatch(copy_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(copy_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && f->same_state(g.structure())
        && iteration.sharing() != glift::Sharing::one_place) {
        const copy_direct_parameters parameters = {
            .f_extent = f->extent(),
        };
        commands.dispatch(copy_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const copy_general_parameters parameters = {
            .size = f.size(),
            .f_origin = f.origin(),
            .g_origin = g.origin(),
            .f_extent_y = f->extent().y,
            .g_extent_y = g->extent().y,
        };
        commands.dispatch(copy_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(copy_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

Turned::Turned(const glift::Commands& commands, uint2 extent)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(glift::saturated_product(std::uint64_t(extent_.x), std::uint64_t(extent_.y))),
      data_(commands.allocate({.name = "Turned.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

Turned::Turned(const glift::Commands& commands, uint2 extent, glift::Memory data)
    : Structure(commands.device()),
      extent_(extent),
      data_extent_(glift::saturated_product(std::uint64_t(extent_.x), std::uint64_t(extent_.y))),
      data_(commands.adopt(std::move(data),
        {.name = "Turned.data", .bytes = glift::buffer_bytes<float>(data_extent_)})) {}

uint2 Turned::domain() const {
    return extent_;
}

bool Turned::same_state(const Turned& other) const {
    return extent_ == other.extent_;
}

void Turned::copy_out(const glift::Commands& commands, const glift::Range<Turned>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_fa044b2c(commands, range, ::std_transfer::Box_2_float(commands, range.size(), box));
}

void Turned::copy_in(const glift::Commands& commands, const glift::Range<Turned>& range,
    const glift::Memory& box) const {
    ::std_transfer::write_box_1eb09855(commands, ::std_transfer::Box_2_float(commands, range.size(), box), range);
}

void Turned::fill(float value, const glift::Range<Turned>& range) {
    ::std_transfer::fill_box_composed_Turned_float(device(), range, value);
}
void Turned::fill(float value) {
    fill(value, *this);
}

}  // namespace composed
