// Made by gliftc from blocks.glift. Changes are lost when it is made again.
#include "blocks.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace blocks {

using namespace glift::types;

namespace {

// address.glift:53: div_ceil<3>
inline uint3 div_ceil(uint3 a, uint3 b) {
    // address.glift:54
    const uint3 any = glift::min(a, uint3(1u));
    // address.glift:55
    return (a - any) / b + any;
}

}  // namespace

namespace {
struct blocks_blocks_Listed_2_direct_parameters {
    uint result_extent;
    uint self_state_value_inside;
    glift::Bool self_state_value_inside_2;
    uint self_capacity;
};
static_assert(offsetof(blocks_blocks_Listed_2_direct_parameters, result_extent) == 0);
static_assert(offsetof(blocks_blocks_Listed_2_direct_parameters, self_state_value_inside) == 4);
static_assert(offsetof(blocks_blocks_Listed_2_direct_parameters, self_state_value_inside_2) == 8);
static_assert(offsetof(blocks_blocks_Listed_2_direct_parameters, self_capacity) == 12);
struct blocks_blocks_Listed_2_general_parameters {
    uint size;
    uint result_origin;
    uint self_state_value_inside;
    glift::Bool self_state_value_inside_2;
    uint self_capacity;
};
static_assert(offsetof(blocks_blocks_Listed_2_general_parameters, size) == 0);
static_assert(offsetof(blocks_blocks_Listed_2_general_parameters, result_origin) == 4);
static_assert(offsetof(blocks_blocks_Listed_2_general_parameters, self_state_value_inside) == 8);
static_assert(offsetof(blocks_blocks_Listed_2_general_parameters, self_state_value_inside_2) == 12);
static_assert(offsetof(blocks_blocks_Listed_2_general_parameters, self_capacity) == 16);
struct blocks_blocks_Listed_2_wide_parameters {
    uint size;
    uint result_origin;
    std::uint64_t self_state_value_inside;
    glift::Bool self_state_value_inside_2;
    uint self_capacity;
    std::uint64_t self_state_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, size) == 0);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, result_origin) == 4);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, self_state_value_inside) == 8);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, self_state_value_inside_2) == 16);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, self_capacity) == 20);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, self_state_data_address) == 24);
static_assert(offsetof(blocks_blocks_Listed_2_wide_parameters, result_data_address) == 32);
}  // namespace

extern const glift::Kernel blocks_blocks_Listed_2_kernel;

GLIFT_SHARED void blocks_blocks_Listed_2(const glift::Commands& commands, const glift::Range<Listed>& self,
    const glift::Range<::std_transfer::Box_1_uint>& result) {
    glift::Iteration iteration(blocks_blocks_Listed_2_kernel);
    iteration.each("result", result);
    iteration.any("self", self);
    const glift::Memory memories[] = {self->state().data(), result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {self, result});
    if (commands.needs_wide(blocks_blocks_Listed_2_kernel, memories, iteration.size())) {
        const blocks_blocks_Listed_2_wide_parameters parameters = {
            .size = result.size(),
            .result_origin = result.origin(),
            .self_state_value_inside = 0u < self->state().extent() ? std::uint64_t{0u} : std::uint64_t{0u},
            .self_state_value_inside_2 = 0u < self->state().extent(),
            .self_capacity = self->capacity(),
            .self_state_data_address = 0u,
            .result_data_address = 0u,
        };
        commands.dispatch(blocks_blocks_Listed_2_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(blocks_blocks_Listed_2_wide_parameters,
            size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const blocks_blocks_Listed_2_direct_parameters parameters = {
            .result_extent = result->extent(),
            .self_state_value_inside = 0u < self->state().extent() ? 0u : 0u,
            .self_state_value_inside_2 = 0u < self->state().extent(),
            .self_capacity = self->capacity(),
        };
        commands.dispatch(blocks_blocks_Listed_2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const blocks_blocks_Listed_2_general_parameters parameters = {
            .size = result.size(),
            .result_origin = result.origin(),
            .self_state_value_inside = 0u < self->state().extent() ? 0u : 0u,
            .self_state_value_inside_2 = 0u < self->state().extent(),
            .self_capacity = self->capacity(),
        };
        commands.dispatch(blocks_blocks_Listed_2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(blocks_blocks_Listed_2_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct scale_direct_parameters {
    uint2 size;
    uint f_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint f_table_extent;
    uint2 f_frames_extent;
    uint3 f_extent;
    float by;
};
static_assert(offsetof(scale_direct_parameters, size) == 0);
static_assert(offsetof(scale_direct_parameters, f_active_extent) == 8);
static_assert(offsetof(scale_direct_parameters, div_ceil_x) == 12);
static_assert(offsetof(scale_direct_parameters, div_ceil_y) == 16);
static_assert(offsetof(scale_direct_parameters, div_ceil_y_2) == 20);
static_assert(offsetof(scale_direct_parameters, div_ceil_x_2) == 24);
static_assert(offsetof(scale_direct_parameters, f_table_extent) == 28);
static_assert(offsetof(scale_direct_parameters, f_frames_extent) == 32);
static_assert(offsetof(scale_direct_parameters, f_extent) == 40);
static_assert(offsetof(scale_direct_parameters, by) == 52);
struct scale_general_parameters {
    uint2 size;
    uint3 g_origin;
    uint3 f_origin;
    uint3 g_size;
    uint g_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint g_table_extent;
    uint2 g_frames_extent;
    uint div_ceil_y_3;
    uint div_ceil_x_3;
    uint f_table_extent;
    uint2 f_frames_extent;
    float by;
};
static_assert(offsetof(scale_general_parameters, size) == 0);
static_assert(offsetof(scale_general_parameters, g_origin) == 8);
static_assert(offsetof(scale_general_parameters, f_origin) == 20);
static_assert(offsetof(scale_general_parameters, g_size) == 32);
static_assert(offsetof(scale_general_parameters, g_active_extent) == 44);
static_assert(offsetof(scale_general_parameters, div_ceil_x) == 48);
static_assert(offsetof(scale_general_parameters, div_ceil_y) == 52);
static_assert(offsetof(scale_general_parameters, div_ceil_y_2) == 56);
static_assert(offsetof(scale_general_parameters, div_ceil_x_2) == 60);
static_assert(offsetof(scale_general_parameters, g_table_extent) == 64);
static_assert(offsetof(scale_general_parameters, g_frames_extent) == 68);
static_assert(offsetof(scale_general_parameters, div_ceil_y_3) == 76);
static_assert(offsetof(scale_general_parameters, div_ceil_x_3) == 80);
static_assert(offsetof(scale_general_parameters, f_table_extent) == 84);
static_assert(offsetof(scale_general_parameters, f_frames_extent) == 88);
static_assert(offsetof(scale_general_parameters, by) == 96);
struct scale_wide_parameters {
    uint2 size;
    uint3 g_origin;
    uint3 f_origin;
    uint3 g_size;
    uint g_active_extent;
    uint div_ceil_x;
    uint div_ceil_y;
    uint div_ceil_y_2;
    uint div_ceil_x_2;
    uint g_table_extent;
    uint g_frames_extent_y;
    uint div_ceil_y_3;
    uint div_ceil_x_3;
    uint f_table_extent;
    std::uint64_t f_frames_extent_x;
    uint f_frames_extent_y;
    std::uint64_t g_frames_extent_x;
    float by;
    std::uint64_t g_active_data_address;
    std::uint64_t f_table_data_address;
    std::uint64_t f_frames_data_address;
    std::uint64_t g_table_data_address;
    std::uint64_t g_frames_data_address;
};
static_assert(offsetof(scale_wide_parameters, size) == 0);
static_assert(offsetof(scale_wide_parameters, g_origin) == 8);
static_assert(offsetof(scale_wide_parameters, f_origin) == 20);
static_assert(offsetof(scale_wide_parameters, g_size) == 32);
static_assert(offsetof(scale_wide_parameters, g_active_extent) == 44);
static_assert(offsetof(scale_wide_parameters, div_ceil_x) == 48);
static_assert(offsetof(scale_wide_parameters, div_ceil_y) == 52);
static_assert(offsetof(scale_wide_parameters, div_ceil_y_2) == 56);
static_assert(offsetof(scale_wide_parameters, div_ceil_x_2) == 60);
static_assert(offsetof(scale_wide_parameters, g_table_extent) == 64);
static_assert(offsetof(scale_wide_parameters, g_frames_extent_y) == 68);
static_assert(offsetof(scale_wide_parameters, div_ceil_y_3) == 72);
static_assert(offsetof(scale_wide_parameters, div_ceil_x_3) == 76);
static_assert(offsetof(scale_wide_parameters, f_table_extent) == 80);
static_assert(offsetof(scale_wide_parameters, f_frames_extent_x) == 88);
static_assert(offsetof(scale_wide_parameters, f_frames_extent_y) == 96);
static_assert(offsetof(scale_wide_parameters, g_frames_extent_x) == 104);
static_assert(offsetof(scale_wide_parameters, by) == 112);
static_assert(offsetof(scale_wide_parameters, g_active_data_address) == 120);
static_assert(offsetof(scale_wide_parameters, f_table_data_address) == 128);
static_assert(offsetof(scale_wide_parameters, f_frames_data_address) == 136);
static_assert(offsetof(scale_wide_parameters, g_table_data_address) == 144);
static_assert(offsetof(scale_wide_parameters, g_frames_data_address) == 152);
}  // namespace

extern const glift::Kernel scale_kernel;

void scale(const glift::Commands& commands, const glift::Range<Listed>& f, float by, const glift::Range<Listed>& g) {
    glift::Iteration iteration(scale_kernel);
    iteration.each("f", f);
    iteration.each("g", g);
    iteration.blocks(uint2(512u, g->capacity()), block_count_blocks_Listed(commands, g));
    const glift::Memory memories[] = {g->active().data(), f->table().data(), f->frames().data(), g->table().data(),
        g->frames().data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (commands.needs_wide(scale_kernel, memories, iteration.extent(), iteration.sharing())) {
        const scale_wide_parameters parameters = {
            .size = iteration.visited(),
            .g_origin = g.origin(),
            .f_origin = f.origin(),
            .g_size = g.size(),
            .g_active_extent = g->active().extent(),
            .div_ceil_x = glift::max(div_ceil(g->extent(), uint3(8u, 8u, 8u)).x, 1u),
            .div_ceil_y = glift::max(div_ceil(g->extent(), uint3(8u, 8u, 8u)).y, 1u),
            .div_ceil_y_2 = div_ceil(g->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_2 = div_ceil(g->extent(), uint3(8u, 8u, 8u)).x,
            .g_table_extent = g->table().extent(),
            .g_frames_extent_y = g->frames().extent().y,
            .div_ceil_y_3 = div_ceil(f->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_3 = div_ceil(f->extent(), uint3(8u, 8u, 8u)).x,
            .f_table_extent = f->table().extent(),
            .f_frames_extent_x = std::uint64_t(f->frames().extent().x),
            .f_frames_extent_y = f->frames().extent().y,
            .g_frames_extent_x = std::uint64_t(g->frames().extent().x),
            .by = by,
            .g_active_data_address = 0u,
            .f_table_data_address = 0u,
            .f_frames_data_address = 0u,
            .g_table_data_address = 0u,
            .g_frames_data_address = 0u,
        };
        iteration.count_blocks(offsetof(scale_wide_parameters, size));
        commands.dispatch(scale_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.extent(),
            .patches = iteration.patches({offsetof(scale_wide_parameters, g_size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && f->same_state(g.structure())
        && iteration.sharing() != glift::Sharing::one_place) {
        const scale_direct_parameters parameters = {
            .size = iteration.visited(),
            .f_active_extent = f->active().extent(),
            .div_ceil_x = glift::max(div_ceil(f->extent(), uint3(8u, 8u, 8u)).x, 1u),
            .div_ceil_y = glift::max(div_ceil(f->extent(), uint3(8u, 8u, 8u)).y, 1u),
            .div_ceil_y_2 = div_ceil(f->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_2 = div_ceil(f->extent(), uint3(8u, 8u, 8u)).x,
            .f_table_extent = f->table().extent(),
            .f_frames_extent = f->frames().extent(),
            .f_extent = f->extent(),
            .by = by,
        };
        iteration.count_blocks(offsetof(scale_direct_parameters, size));
        commands.dispatch(scale_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.extent(), .patches = iteration.patches({}),
            .sharing = iteration.sharing()});
    } else {
        const scale_general_parameters parameters = {
            .size = iteration.visited(),
            .g_origin = g.origin(),
            .f_origin = f.origin(),
            .g_size = g.size(),
            .g_active_extent = g->active().extent(),
            .div_ceil_x = glift::max(div_ceil(g->extent(), uint3(8u, 8u, 8u)).x, 1u),
            .div_ceil_y = glift::max(div_ceil(g->extent(), uint3(8u, 8u, 8u)).y, 1u),
            .div_ceil_y_2 = div_ceil(g->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_2 = div_ceil(g->extent(), uint3(8u, 8u, 8u)).x,
            .g_table_extent = g->table().extent(),
            .g_frames_extent = g->frames().extent(),
            .div_ceil_y_3 = div_ceil(f->extent(), uint3(8u, 8u, 8u)).y,
            .div_ceil_x_3 = div_ceil(f->extent(), uint3(8u, 8u, 8u)).x,
            .f_table_extent = f->table().extent(),
            .f_frames_extent = f->frames().extent(),
            .by = by,
        };
        iteration.count_blocks(offsetof(scale_general_parameters, size));
        commands.dispatch(scale_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.extent(),
            .patches = iteration.patches({offsetof(scale_general_parameters, g_size)}),
            .sharing = iteration.sharing()});
    }
}

Listed::Listed(const glift::Commands& commands, const Numbers& table, const Numbers& active, const Numbers& state,
    uint3 extent, uint capacity)
    : Structure(commands.device()),
      extent_(extent),
      capacity_(capacity),
      table_(table),
      active_(active),
      state_(state),
      frames_(::std_array::Array_2_float_none_buffer(commands, uint2(512u, capacity_))) {}

Listed::Listed(const glift::Commands& commands, const Numbers& table, const Numbers& active, const Numbers& state,
    uint3 extent, uint capacity, ::std_array::Array_2_float_none_buffer frames)
    : Structure(commands.device()),
      extent_(extent),
      capacity_(capacity),
      table_(table),
      active_(active),
      state_(state),
      frames_(glift::detail::part(std::move(frames), frames.extent() == uint2(512u, capacity_), "Listed.frames")) {}

uint3 Listed::domain() const {
    return extent_;
}

bool Listed::same_state(const Listed& other) const {
    return extent_ == other.extent_ && capacity_ == other.capacity_ && table_.same_state(other.table_)
        && active_.same_state(other.active_) && state_.same_state(other.state_) && frames_.same_state(other.frames_);
}

void Listed::copy_out(const glift::Commands& commands, const glift::Range<Listed>& range,
    const glift::Memory& box) const {
    ::std_transfer::read_box_a23c245a(commands, range, ::std_transfer::Box_3_float(commands, range.size(), box));
}

void Listed::list(const glift::Commands& commands, const glift::Range<Listed>& range, glift::uint most,
    const glift::Memory& counter, const glift::Memory& addresses, const glift::Memory& places,
    const glift::Memory& values) const {
    ::std_transfer::list_there_b56b1eed(commands, range, *this, *this, ::std_transfer::Box_1_uint(commands, 1, counter),
        ::std_transfer::Box_1_uint3(commands, most, addresses), ::std_transfer::Box_1_uint2(commands, most, places),
        ::std_transfer::Box_1_float(commands, most, values));
}

void Listed::copy_in(const glift::Commands& commands, const glift::Range<Listed>& range,
    const glift::Memory& box) const {
    ::std_transfer::write_box_93a8b595(commands, ::std_transfer::Box_3_float(commands, range.size(), box), range);
}

void Listed::fill(float value, const glift::Range<Listed>& range) {
    ::std_transfer::fill_box_blocks_Listed_float(device(), range, value);
}
void Listed::fill(float value) {
    fill(value, *this);
}

// blocks.glift:16: Listed.blocks
GLIFT_SHARED glift::DeviceScalar<uint> blocks_blocks_Listed(const glift::Commands& commands,
    const glift::Range<Listed>& self) {
    // blocks.glift:16
    ::std_transfer::Box_1_uint result(commands.uninitialized(), 1u);
    blocks_blocks_Listed_2(commands, self, result);
    return result.element_in_place(commands, 0u);
}

// blocks.glift:16: Listed.blocks, the element
GLIFT_SHARED glift::DeviceScalar<uint> block_count_blocks_Listed(const glift::Commands& commands,
    const glift::Range<Listed>& self) {
    // blocks.glift:16
    if (0u < self->state().domain()) {
        return self->state().element_in_place(commands, 0u);
    }
    return blocks_blocks_Listed(commands, self);
}

}  // namespace blocks
