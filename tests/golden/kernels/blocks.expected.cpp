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

extern const glift::Kernel blocks_blocks_Listed_2_kernel;

GLIFT_SHARED void blocks_blocks_Listed_2(const glift::Commands& commands, const glift::Range<Listed>& self,
    const glift::Range<::std_transfer::Box_1_uint>& result) {
    glift::Iteration iteration(blocks_blocks_Listed_2_kernel);
    iteration.each("result", result);
    iteration.any("self", self);
    const glift::Memory memories[] = {self->state().data(), result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {self, result});
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint result_extent;
            uint self_state_value_inside;
            glift::Bool self_state_value_inside_2;
            uint self_capacity;
        } parameters = {result->extent(), 0u < self->state().extent() ? 0u : 0u, 0u < self->state().extent(),
            self->capacity()};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint result_origin;
            uint self_state_value_inside;
            glift::Bool self_state_value_inside_2;
            uint self_capacity;
            std::uint64_t addresses[2];
        } parameters = {result.size(), result.origin(), 0u < self->state().extent() ? 0u : 0u,
            0u < self->state().extent(), self->capacity(), {}};
        static_assert(sizeof parameters == 40);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel scale_kernel;

void scale(const glift::Commands& commands, const glift::Range<Listed>& f, float by, const glift::Range<Listed>& g) {
    glift::Iteration iteration(scale_kernel);
    iteration.each("f", f);
    iteration.each("g", g);
    iteration.blocks(uint2(512u, g->capacity()), block_count_blocks_Listed(commands, g));
    const glift::Memory memories[] = {g->active().data(), f->table().data(), f->frames().data(), g->table().data(),
        g->frames().data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {f, g});
    if (iteration.can_be_direct(commands, memories) && f->same_state(g.structure())) {
        const struct {
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
        } parameters = {iteration.visited(), f->active().extent(),
            glift::max(div_ceil(f->extent(), uint3(8u, 8u, 8u)).x, 1u),
            glift::max(div_ceil(f->extent(), uint3(8u, 8u, 8u)).y, 1u), div_ceil(f->extent(), uint3(8u, 8u, 8u)).y,
            div_ceil(f->extent(), uint3(8u, 8u, 8u)).x, f->table().extent(), f->frames().extent(), f->extent(), by};
        static_assert(sizeof parameters == 56);
        iteration.count_blocks(0);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
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
            std::uint64_t addresses[5];
        } parameters = {iteration.visited(), g.origin(), f.origin(), g.size(), g->active().extent(),
            glift::max(div_ceil(g->extent(), uint3(8u, 8u, 8u)).x, 1u),
            glift::max(div_ceil(g->extent(), uint3(8u, 8u, 8u)).y, 1u), div_ceil(g->extent(), uint3(8u, 8u, 8u)).y,
            div_ceil(g->extent(), uint3(8u, 8u, 8u)).x, g->table().extent(), g->frames().extent(),
            div_ceil(f->extent(), uint3(8u, 8u, 8u)).y, div_ceil(f->extent(), uint3(8u, 8u, 8u)).x, f->table().extent(),
            f->frames().extent(), by, {}};
        static_assert(sizeof parameters == 144);
        iteration.count_blocks(0);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {32});
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
      frames_(::std_array::Array_2_float(commands, uint2(512u, capacity_))) {}

Listed::Listed(const glift::Commands& commands, const Numbers& table, const Numbers& active, const Numbers& state,
    uint3 extent, uint capacity, ::std_array::Array_2_float frames)
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

uint3 Listed::block_extent() const {
    return uint3(8u, 8u, 8u);
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
    const glift::PipelineMark _mark("Listed.blocks", "blocks.glift:16");
    // blocks.glift:16
    ::std_transfer::Box_1_uint result(commands.uninitialized(), 1u);
    blocks_blocks_Listed_2(commands, self, result);
    return result.element_in_place(commands, 0u);
}

// blocks.glift:16: Listed.blocks, the element
GLIFT_SHARED glift::DeviceScalar<uint> block_count_blocks_Listed(const glift::Commands& commands,
    const glift::Range<Listed>& self) {
    const glift::PipelineMark _mark("Listed.blocks, the element", "blocks.glift:16");
    // blocks.glift:16
    if (0u < self->state().domain()) {
        return self->state().element_in_place(commands, 0u);
    }
    return blocks_blocks_Listed(commands, self);
}

}  // namespace blocks
