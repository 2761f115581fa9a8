// Made by gliftc from near_blocks.glift. Changes are lost when it is made again.
#include "near_blocks.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace near_blocks {

using namespace glift::types;

namespace {

// address.glift:53: div_ceil<2>
inline uint2 div_ceil(uint2 a, uint2 b) {
    // address.glift:54
    const uint2 any = glift::min(a, uint2(1u));
    // address.glift:55
    return (a - any) / b + any;
}

}  // namespace

namespace {
struct right_direct_parameters {
    uint2 size;
    uint f_active_extent;
    uint div_ceil_x;
    uint div_ceil_x_2;
    uint f_table_extent;
    uint2 f_frames_extent;
    uint2 f_extent;
};
static_assert(offsetof(right_direct_parameters, size) == 0);
static_assert(offsetof(right_direct_parameters, f_active_extent) == 8);
static_assert(offsetof(right_direct_parameters, div_ceil_x) == 12);
static_assert(offsetof(right_direct_parameters, div_ceil_x_2) == 16);
static_assert(offsetof(right_direct_parameters, f_table_extent) == 20);
static_assert(offsetof(right_direct_parameters, f_frames_extent) == 24);
static_assert(offsetof(right_direct_parameters, f_extent) == 32);
struct right_general_parameters {
    uint2 size;
    uint2 g_origin;
    uint2 f_origin;
    uint2 g_size;
    uint g_active_extent;
    uint div_ceil_x;
    uint div_ceil_x_2;
    uint g_table_extent;
    uint2 g_frames_extent;
    uint div_ceil_x_3;
    uint f_table_extent;
    uint2 f_frames_extent;
    uint2 f_extent;
};
static_assert(offsetof(right_general_parameters, size) == 0);
static_assert(offsetof(right_general_parameters, g_origin) == 8);
static_assert(offsetof(right_general_parameters, f_origin) == 16);
static_assert(offsetof(right_general_parameters, g_size) == 24);
static_assert(offsetof(right_general_parameters, g_active_extent) == 32);
static_assert(offsetof(right_general_parameters, div_ceil_x) == 36);
static_assert(offsetof(right_general_parameters, div_ceil_x_2) == 40);
static_assert(offsetof(right_general_parameters, g_table_extent) == 44);
static_assert(offsetof(right_general_parameters, g_frames_extent) == 48);
static_assert(offsetof(right_general_parameters, div_ceil_x_3) == 56);
static_assert(offsetof(right_general_parameters, f_table_extent) == 60);
static_assert(offsetof(right_general_parameters, f_frames_extent) == 64);
static_assert(offsetof(right_general_parameters, f_extent) == 72);
struct right_wide_parameters {
    uint2 size;
    uint2 g_origin;
    uint2 f_origin;
    uint2 g_size;
    uint g_active_extent;
    uint div_ceil_x;
    uint div_ceil_x_2;
    uint g_table_extent;
    uint g_frames_extent_y;
    uint div_ceil_x_3;
    uint f_table_extent;
    std::uint64_t f_frames_extent_x;
    uint f_frames_extent_y;
    std::uint64_t g_frames_extent_x;
    uint2 f_extent;
    std::uint64_t g_active_data_address;
    std::uint64_t f_table_data_address;
    std::uint64_t f_frames_data_address;
    std::uint64_t g_table_data_address;
    std::uint64_t g_frames_data_address;
};
static_assert(offsetof(right_wide_parameters, size) == 0);
static_assert(offsetof(right_wide_parameters, g_origin) == 8);
static_assert(offsetof(right_wide_parameters, f_origin) == 16);
static_assert(offsetof(right_wide_parameters, g_size) == 24);
static_assert(offsetof(right_wide_parameters, g_active_extent) == 32);
static_assert(offsetof(right_wide_parameters, div_ceil_x) == 36);
static_assert(offsetof(right_wide_parameters, div_ceil_x_2) == 40);
static_assert(offsetof(right_wide_parameters, g_table_extent) == 44);
static_assert(offsetof(right_wide_parameters, g_frames_extent_y) == 48);
static_assert(offsetof(right_wide_parameters, div_ceil_x_3) == 52);
static_assert(offsetof(right_wide_parameters, f_table_extent) == 56);
static_assert(offsetof(right_wide_parameters, f_frames_extent_x) == 64);
static_assert(offsetof(right_wide_parameters, f_frames_extent_y) == 72);
static_assert(offsetof(right_wide_parameters, g_frames_extent_x) == 80);
static_assert(offsetof(right_wide_parameters, f_extent) == 88);
static_assert(offsetof(right_wide_parameters, g_active_data_address) == 96);
static_assert(offsetof(right_wide_parameters, f_table_data_address) == 104);
static_assert(offsetof(right_wide_parameters, f_frames_data_address) == 112);
static_assert(offsetof(right_wide_parameters, g_table_data_address) == 120);
static_assert(offsetof(right_wide_parameters, g_frames_data_address) == 128);
}  // namespace

extern const glift::Kernel right_kernel;

void right(const glift::Commands& commands, const glift::Range<Listed>& f, const glift::Range<Listed>& g) {
    glift::Iteration iteration(right_kernel);
    iteration.each("g", g);
    iteration.near("f", f);
    iteration.blocks(uint2(64u, g->capacity()));
    const glift::Memory memories[] = {g->active().data(), f->table().data(), f->frames().data(), g->table().data(),
        g->frames().data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (commands.needs_wide(right_kernel, memories, iteration.extent())) {
        const right_wide_parameters parameters = {
            .size = iteration.visited(),
            .g_origin = g.origin(),
            .f_origin = iteration.centre(f),
            .g_size = g.size(),
            .g_active_extent = g->active().extent(),
            .div_ceil_x = glift::max(div_ceil(g->extent(), uint2(8u, 8u)).x, 1u),
            .div_ceil_x_2 = div_ceil(g->extent(), uint2(8u, 8u)).x,
            .g_table_extent = g->table().extent(),
            .g_frames_extent_y = g->frames().extent().y,
            .div_ceil_x_3 = div_ceil(f->extent(), uint2(8u, 8u)).x,
            .f_table_extent = f->table().extent(),
            .f_frames_extent_x = std::uint64_t(f->frames().extent().x),
            .f_frames_extent_y = f->frames().extent().y,
            .g_frames_extent_x = std::uint64_t(g->frames().extent().x),
            .f_extent = f->extent(),
            .g_active_data_address = 0u,
            .f_table_data_address = 0u,
            .f_frames_data_address = 0u,
            .g_table_data_address = 0u,
            .g_frames_data_address = 0u,
        };
        iteration.count_blocks(offsetof(right_wide_parameters, size));
        commands.dispatch(right_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.extent(),
            .patches = iteration.patches({offsetof(right_wide_parameters, g_size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && f->same_state(g.structure())) {
        const right_direct_parameters parameters = {
            .size = iteration.visited(),
            .f_active_extent = f->active().extent(),
            .div_ceil_x = glift::max(div_ceil(f->extent(), uint2(8u, 8u)).x, 1u),
            .div_ceil_x_2 = div_ceil(f->extent(), uint2(8u, 8u)).x,
            .f_table_extent = f->table().extent(),
            .f_frames_extent = f->frames().extent(),
            .f_extent = f->extent(),
        };
        iteration.count_blocks(offsetof(right_direct_parameters, size));
        commands.dispatch(right_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.extent(), .patches = iteration.patches({}),
            .sharing = iteration.sharing()});
    } else {
        const right_general_parameters parameters = {
            .size = iteration.visited(),
            .g_origin = g.origin(),
            .f_origin = iteration.centre(f),
            .g_size = g.size(),
            .g_active_extent = g->active().extent(),
            .div_ceil_x = glift::max(div_ceil(g->extent(), uint2(8u, 8u)).x, 1u),
            .div_ceil_x_2 = div_ceil(g->extent(), uint2(8u, 8u)).x,
            .g_table_extent = g->table().extent(),
            .g_frames_extent = g->frames().extent(),
            .div_ceil_x_3 = div_ceil(f->extent(), uint2(8u, 8u)).x,
            .f_table_extent = f->table().extent(),
            .f_frames_extent = f->frames().extent(),
            .f_extent = f->extent(),
        };
        iteration.count_blocks(offsetof(right_general_parameters, size));
        commands.dispatch(right_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.extent(),
            .patches = iteration.patches({offsetof(right_general_parameters, g_size)}),
            .sharing = iteration.sharing()});
    }
}

Listed::Listed(const glift::Commands& commands, const Numbers& table, const Numbers& active, uint2 extent,
    uint capacity)
    : Structure(commands.device()),
      extent_(extent),
      capacity_(capacity),
      table_(table),
      active_(active),
      frames_(::std_array::Array_2_float_none_buffer(commands, uint2(64u, capacity_))) {}

Listed::Listed(const glift::Commands& commands, const Numbers& table, const Numbers& active, uint2 extent,
    uint capacity, ::std_array::Array_2_float_none_buffer frames)
    : Structure(commands.device()),
      extent_(extent),
      capacity_(capacity),
      table_(table),
      active_(active),
      frames_(glift::detail::part(std::move(frames), frames.extent() == uint2(64u, capacity_), "Listed.frames")) {}

uint2 Listed::domain() const {
    return extent_;
}

bool Listed::same_state(const Listed& other) const {
    return extent_ == other.extent_ && capacity_ == other.capacity_ && table_.same_state(other.table_)
        && active_.same_state(other.active_) && frames_.same_state(other.frames_);
}

void Listed::copy_out(const glift::Commands& commands, const glift::Range<Listed>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_9bb01b1e(commands, range, ::std_transfer::Box_2_float(commands, range.size(), box));
}

void Listed::list(const glift::Commands& commands, const glift::Range<Listed>& range, glift::uint most,
    const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
    const glift::Memory& values) const {
    ::std_transfer::list_there_d7a68012(commands, range, *this, *this, ::std_transfer::Box_1_uint(commands, 1, counter),
        ::std_transfer::Box_1_uint2(commands, most, addresses), ::std_transfer::Box_1_uint2(commands, most, places),
        ::std_transfer::Box_1_float(commands, most, values));
}

void Listed::copy_in(const glift::Commands& commands, const glift::Range<Listed>& range,
    const glift::Memory& box) const {
    ::std_transfer::write_box_bdc9234f(commands, ::std_transfer::Box_2_float(commands, range.size(), box), range);
}

void Listed::fill(float value, const glift::Range<Listed>& range) {
    ::std_transfer::fill_box_c2b13d34(device(), range, value);
}
void Listed::fill(float value) {
    fill(value, *this);
}

}  // namespace near_blocks
